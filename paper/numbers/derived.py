# SPDX-License-Identifier: MIT
"""Ratios, costs, slopes and shares of the floor, derived from records."""
import math
import statistics
from dataclasses import dataclass
from pathlib import Path

from paper.numbers.ratios import family, time_ratio
from paper.records import Missing
from paper.spread import t_interval

SHADERS = Path(__file__).resolve().parents[2] / "shaders"
ORDER = ("clear", "grid_clear", "grid_bounds", "split_tiles", "split_count", "split_scan", "grid_split", "grid_sort", "grid_count",
         "grid_sums", "grid_scan", "grid_scatter", "collide", "resolve_undecided", "tally")  # of the kernels of a collision step
INSTRUCTIONS = 4  # three fused multiply-adds and a comparison per pair, the minimum for the Gram form
BEYOND_EMPTY = 10  # times an empty kernel's reading: the timer is at most a tenth of a kernel's
SYNTHETIC = "peak_"  # kernels that measure the device, not the program
# Per sphere, as in bench/measure/floors.h; records from before split_tiles counted 111 or 128.
GRID_BYTES = {"warm": 43, "cold": 91}


def issue_rate(machine):
    """Lane-instructions a second: multiprocessors x 128 lanes x highest clock."""
    details = machine.backend("cuda")["details"]
    return float(details["multiprocessors"]) * 128 * float(details["highest clock MHz"]) * 1e6


def share_of_floor(machine, record):
    """Percent."""
    pairs = 0.5 * record.n * (record.n - 1)
    return 100 * pairs / (1e-3 * record.median) * INSTRUCTIONS / issue_rate(machine)


def copy_rate(machine):
    """Bytes a second, the base of every share: the highest that was recorded of data that fits no cache, in either API."""
    rates = [record.peak_per_second for record in machine.select(table="grid", method="collide_grid")
             if "peak_per_second" in record.parameters]
    rates += [copy["bytes_per_second"] for root in machine.sources.values() for copy in root.get("copies", ())
              if not copy["sample"].get("fits_l2")]
    if not rates:
        raise Missing(f"{machine.name} has no record of the rate of copying")
    return max(rates)


def grid_share_of_floor(machine, row):
    """Percent: the time of moving GRID_BYTES at the machine's copy rate, over the measured time."""
    return 100 * GRID_BYTES[row.order] * row.n / copy_rate(machine) / (1e-3 * row.median)


def slope(small, large):
    return math.log(large.median / small.median) / math.log(large.n / small.n)


def ratio(glsl, cuda):
    found = time_ratio(glsl, cuda)
    return found.middle, found.middle - found.low, found.high - found.middle


def matched(machine, **wanted):
    """(parameter record of GLSL, of CUDA) for every size both have."""
    if not (machine.has("opengl") and machine.has("cuda")):
        raise Missing(f"{machine.name} was not run with both GLSL and CUDA")
    glsl, cuda = (machine.need(backend=name, **wanted) for name in ("opengl", "cuda"))
    by_n = {record.n: record for record in cuda}
    return [(record, by_n[record.n]) for record in glsl if record.n in by_n]


def best(machine, name, method):
    n = max(record.n for record in machine.need(table="methods"))
    return min(machine.need(table="methods", backend=name, method=method, n=n), key=lambda record: record.median)


def cost(naive, exact):
    """Percent: (middle, low, high)."""
    found = time_ratio(exact, naive)
    return [100 * (value - 1) for value in (found.middle, found.low, found.high)]


def pairs_of(machine):
    """(exact record, naive record), slowest first within each backend."""
    rows = [record for record in machine.need(table="exactness", exact=True)]
    n = max(record.n for record in rows)
    for exact in rows:
        if exact.n == n:
            yield exact, machine.one(table="exactness", exact=False, backend=exact.backend, method=exact.method, n=n)


def devices_of(machine):
    """The GPU APIs of a machine, in the order of the figures; Missing without any."""
    found = [name for name in ("opengl", "vulkan", "cuda") if machine.has(name)]
    if not found:
        raise Missing(f"{machine.name} has no OpenGL, Vulkan or CUDA: record it on a machine with one of them")
    return found


def needed_devices(machine, **wanted):
    """The APIs that have such records; Missing if none has."""
    machine.need(**wanted)
    devices = [name for name in ("opengl", "cuda") if machine.select(backend=name, **wanted)]
    if not devices:
        raise Missing(f"{machine.name} has no record of GLSL or CUDA in the table {wanted['table']}")
    return devices


def crossover(machine, backend, fraction):
    """The least n from which the grid in random order is faster than all pairs at every size that both have; None if there
    is none."""
    wanted = {"table": "grid", "scene": "uniform", "packing_fraction": fraction, "backend": backend, "order": "cold"}
    grid = {record.n: record for record in machine.select(**wanted, method="collide_grid")}
    both = [(grid[pairs.n], pairs) for pairs in machine.select(**wanted, method="collide_triangle") if pairs.n in grid]
    found = None
    for (row, _), compared in reversed(list(zip(both, family(both)))):
        if not (compared.decided and compared.middle < 1):
            break
        found = row.n
    return found


@dataclass(frozen=True)
class StageRatio:
    kernel: str
    where: str
    ratio: tuple  # OpenGL over CUDA: value, distance to the lower and to the upper bound
    cuda_ms: float
    source: str


def over_processes(kernel, glsl, cuda):
    """The ratio in each process that timed the kernel in both."""
    of_glsl, of_cuda = ({run["process"]: run["device_stages_ms"][kernel] for run in record.parameters.get("processes", ())
                         if kernel in run.get("device_stages_ms", {})} for record in (glsl, cuda))
    return [of_glsl[k] / of_cuda[k] for k in of_glsl if k in of_cuda]


def stage_ratio(kernel, glsl, cuda):
    """Over processes, or of one process from both medians and their intervals. None where a reading is no longer than the
    timer's of an empty kernel."""
    (least, most), (low, high) = (record.device_stages_interval_ms[kernel] for record in (cuda, glsl))
    if any(kernel in record.parameters.get("device_stages_at_floor", []) for record in (glsl, cuda)) or min(least, low) <= 0:
        return None
    found = over_processes(kernel, glsl, cuda)
    several = len(found) > 1
    middle = statistics.median(found) if several else glsl.device_stages_ms[kernel] / cuda.device_stages_ms[kernel]
    below, above = t_interval(found) if several else (low / most, high / least)
    return StageRatio(kernel, f"$n$ = {glsl.n:,}", (middle, middle - below, above - middle), cuda.device_stages_ms[kernel], cuda.source)


def timer_floor(machine, **wanted):
    """Milliseconds: the longest device timer's reading of an empty kernel; 0 without a record."""
    return max((time / record.launches_per_step for record in machine.select(table="overhead", **wanted)
                for time in record.parameters.get("device_stages_ms", {}).values()), default=0)


def stage_ratios(machine):
    """Each kernel timed by device timers in both APIs in the same work of one run, at the largest n; of several such
    records the latest, and of that run the one with the tightest bounds: a kernel may run several times per frame. Only
    kernels whose reading in both is BEYOND_EMPTY times the longest of an empty one."""
    found, least = {}, BEYOND_EMPTY * timer_floor(machine)
    timed = [record for record in machine.records if {"device_stages_interval_ms", "n"} <= record.parameters.keys() and
             record.parameters.get("work") != "loop"]  # its spheres have moved
    by_work = {(record.source, work_of(record), record.backend): record for record in timed}
    for (run, work, backend), glsl in by_work.items():
        cuda = by_work.get((run, work, "cuda"))
        if backend == "opengl" and cuda:
            for kernel in glsl.device_stages_ms.keys() & cuda.device_stages_ms.keys():
                row = stage_ratio(kernel, glsl, cuda)
                long = row and all(record.device_stages_ms[kernel] >= least for record in (glsl, cuda))
                found.setdefault(kernel, []).append((glsl.n, glsl.date, -spread(row) if row else -math.inf, row, long))
    for kernel in sorted(found):
        *_, row, long = max(found[kernel], key=lambda entry: entry[:3])
        if long:
            yield row


def kernels_alone(machine):
    """The program's kernels among them, the greatest ratio first. Of the variants of one source the longest counts."""
    rows = [row for row in stage_ratios(machine) if not row.kernel.startswith(SYNTHETIC)]
    if not rows:
        raise Missing(f"{machine.name} has no kernel that takes {BEYOND_EMPTY} times an empty one's reading in both APIs")
    variants = {}
    for row in rows:
        variants.setdefault(source_kernel(row.kernel), []).append(row)
    longest = [max(own, key=lambda row: row.cuda_ms) for own in variants.values()]
    return sorted(longest, key=lambda row: -row.ratio[0])


def source_kernel(stage):
    """The kernel whose source a stage runs: draw_cull of draw_cull_near."""
    own = {path.stem for path in SHADERS.rglob("*.comp")}
    return max((name for name in own if f"{stage}_".startswith(f"{name}_")), key=len, default=stage)


def spread(row):
    """Upper over lower bound of the ratio."""
    middle, below, above = row.ratio
    return (middle + above) / (middle - below)


def work_of(record):
    """The parameters that two records of different APIs must share; in the grid each API uses its own group size."""
    names = ("table", "work", "n", "method", "exact", "order", "dt", "precision", "draw", "place",
             *(() if record.parameters.get("table") == "grid" else ("block",)))
    return (*(str(record.parameters.get(name)) for name in names), str(record.parameters.get("scene")))


def in_order(stages):
    """Each once, in the order of execution; unknown ones first."""
    return sorted(dict.fromkeys(stages), key=lambda name: ORDER.index(name) if name in ORDER else -1)


def stage_bars(record):
    """Kernel -> milliseconds per step; every search kernel as `collide`."""
    return {"collide" if name.startswith("collide") else name: time for name, time in record.device_stages_ms.items()}


def over_other_sums(machine, sums):
    """(n, API) -> a step with integer sums of impulses, the same with these."""
    rows = {(row.n, row.backend, row.sums): row for row in machine.need(table="contact_sums")}
    return {(n, name): (rows[n, name, "integers"], row) for (n, name, other), row in rows.items() if other == sums}


def driver_record(machine):
    """(id, kernel -> compile time by the GL driver) of `spherepair devices --compile`; empty without a record."""
    return next(((root["id"], backend["compile_ms"]) for root in machine.sources.values() for backend in root.get("backends", [])
                 if isinstance(backend, dict) and backend.get("compile_ms")), ("", {}))


def driver_milliseconds(machine):
    return driver_record(machine)[1]
