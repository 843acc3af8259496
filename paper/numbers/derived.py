# SPDX-License-Identifier: MIT
"""Ratios, costs, slopes and shares of the floor, derived from records."""
import math
from dataclasses import dataclass

from paper.numbers.ranks import apart, time_ratio
from paper.records import Missing

ORDER = ("clear", "grid_clear", "grid_bounds", "split_tiles", "split_count", "split_scan", "grid_split", "grid_sort", "grid_count",
         "grid_sums", "grid_scan", "grid_scatter", "collide", "resolve_undecided", "tally")  # of the kernels of a collision step
INSTRUCTIONS = 4  # three fused multiply-adds and a comparison per pair, the minimum for the Gram form
BEYOND_EMPTY = 1.1  # a reading within a tenth of that of an empty kernel shows the timer
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
    rates += [copy["bytes_per_second"] for root in machine.sources.values() for copy in root.get("copies", ())]
    if not rates:
        raise Missing(f"{machine.name} has no record of the rate of copying")
    return max(rates)


def grid_share_of_floor(machine, row):
    """Percent: the time of moving GRID_BYTES at the machine's copy rate, over the measured time."""
    return 100 * GRID_BYTES[row.order] * row.n / copy_rate(machine) / (1e-3 * row.median)


def slope(small, large):
    return math.log(large.median / small.median) / math.log(large.n / small.n)


def ratio(glsl, cuda):
    middle, low, high = time_ratio(glsl, cuda)
    return middle, middle - low, high - middle


def matched(machine, **wanted):
    """(parameter record of GLSL, of CUDA) for every size both have."""
    if not (machine.has("glsl") and machine.has("cuda")):
        raise Missing(f"{machine.name} was not run with both GLSL and CUDA")
    glsl, cuda = (machine.need(backend=name, **wanted) for name in ("glsl", "cuda"))
    by_n = {record.n: record for record in cuda}
    return [(record, by_n[record.n]) for record in glsl if record.n in by_n]


def best(machine, name, method):
    n = max(record.n for record in machine.need(table="methods"))
    return min(machine.need(table="methods", backend=name, method=method, n=n), key=lambda record: record.median)


def cost(naive, exact):
    middle = exact.median / naive.median
    return [100 * (value - 1) for value in (middle, exact.low / naive.high, exact.high / naive.low)]


def pairs_of(machine):
    """(exact record, naive record), slowest first within each backend."""
    rows = [record for record in machine.need(table="exactness", exact=True)]
    n = max(record.n for record in rows)
    for exact in rows:
        if exact.n == n:
            yield exact, machine.one(table="exactness", exact=False, backend=exact.backend, method=exact.method, n=n)


def needed_devices(machine, **wanted):
    """The APIs that have such records; Missing if none has."""
    machine.need(**wanted)
    devices = [name for name in ("glsl", "cuda") if machine.select(backend=name, **wanted)]
    if not devices:
        raise Missing(f"{machine.name} has no record of GLSL or CUDA in the table {wanted['table']}")
    return devices


def crossover(machine, backend, fraction):
    """The least n from which the grid in random order is faster than all pairs at every size that both have, with
    intervals that do not overlap; None if there is none."""
    wanted = {"table": "grid", "scene": "uniform", "packing_fraction": fraction, "backend": backend, "order": "cold"}
    grid = {record.n: record for record in machine.select(**wanted, method="collide_grid")}
    found = None
    for pairs in reversed(machine.select(**wanted, method="collide_triangle")):
        if pairs.n in grid:
            if not (apart(grid[pairs.n], pairs) and grid[pairs.n].median < pairs.median):
                break
            found = pairs.n
    return found


@dataclass(frozen=True)
class StageRatio:
    kernel: str
    where: str
    ratio: tuple  # GLSL over CUDA: value, distance to the lower and to the upper bound
    cuda_ms: float
    source: str


def stage_ratio(kernel, glsl, cuda):
    low, high = glsl.device_stages_interval_ms[kernel]
    least, most = cuda.device_stages_interval_ms[kernel]
    if any(kernel in record.parameters.get("device_stages_at_floor", []) for record in (glsl, cuda)):
        return None  # no longer than the timer's reading of an empty kernel
    if least <= 0 or low <= 0:
        return None
    middle = glsl.device_stages_ms[kernel] / cuda.device_stages_ms[kernel]
    return StageRatio(kernel, f"$n$ = {glsl.n:,}", (middle, middle - low / most, high / least - middle),
                      cuda.device_stages_ms[kernel], cuda.source)


def timer_floor(machine, **wanted):
    """Milliseconds: the longest device timer's reading of an empty kernel; 0 without a record."""
    return max((time / record.launches_per_step for record in machine.select(table="overhead", **wanted)
                for time in record.parameters.get("device_stages_ms", {}).values()), default=0)


def stage_ratios(machine):
    """Each kernel timed by device timers in both APIs in the same work of one run, at the largest n; of several such
    records the latest, and of that run the one with the tightest bounds: a kernel may run several times per frame. None of
    a kernel whose reading there is that of an empty one."""
    found, floors = {}, {name: timer_floor(machine, backend=name) for name in ("glsl", "cuda")}
    timed = [record for record in machine.records if {"device_stages_interval_ms", "n"} <= record.parameters.keys() and
             record.parameters.get("work") != "loop"]  # its spheres have moved
    by_work = {(record.source, work_of(record), record.backend): record for record in timed}
    for (run, work, backend), glsl in by_work.items():
        cuda = by_work.get((run, work, "cuda"))
        if backend == "glsl" and cuda:
            for kernel in glsl.device_stages_ms.keys() & cuda.device_stages_ms.keys():
                row = stage_ratio(kernel, glsl, cuda)
                beyond = row and all(record.device_stages_ms[kernel] > BEYOND_EMPTY * floors[record.backend]
                                     for record in (glsl, cuda))
                found.setdefault(kernel, []).append((glsl.n, glsl.date, -spread(row) if row else -math.inf, row, beyond))
    for kernel in sorted(found):
        *_, row, beyond = max(found[kernel], key=lambda entry: entry[:3])
        if beyond:
            yield row


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
