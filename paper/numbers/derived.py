# SPDX-License-Identifier: MIT
"""What figures and numbers derive from records: ratios, costs, slopes, shares of the instruction floor."""
import math
from dataclasses import dataclass

from ranks import apart
from records import Missing

ORDER = ("clear", "grid_clear", "grid_bounds", "split_tiles", "split_count", "split_scan", "grid_split", "grid_sort", "grid_count",
         "grid_sums", "grid_scan", "grid_scatter", "collide", "settle", "tally")  # of the kernels of a collision step
INSTRUCTIONS = 4  # three fused multiply-adds and a comparison a pair, the least for the form that is used
# A sphere, as bench/measure/floors.h reckons them; records before there was split_tiles counted 111 or 128.
GRID_BYTES = {"warm": 43, "cold": 91}


def issue_rate(machine):
    """Lane-instructions a second: multiprocessors x 128 lanes x highest clock."""
    details = machine.backend("cuda")["details"]
    return float(details["multiprocessors"]) * 128 * float(details["highest clock MHz"]) * 1e6


def share_of_floor(machine, record):
    """Percent."""
    pairs = 0.5 * record.n * (record.n - 1)
    return 100 * pairs / (1e-3 * record.median) * INSTRUCTIONS / issue_rate(machine)


def grid_share_of_floor(row):
    """Percent: the bytes of GRID_BYTES at the rate at which the run saw its device copy, over the time."""
    return 100 * GRID_BYTES[row.order] * row.n / row.ceiling_per_second / (1e-3 * row.median)


def slope(small, large):
    return math.log(large.median / small.median) / math.log(large.n / small.n)


def ratio(glsl, cuda):
    middle = glsl.median / cuda.median
    return middle, middle - glsl.low / cuda.high, glsl.high / cuda.low - middle


def matched(machine, **wanted):
    """(parameter record of GLSL, of CUDA) for every size both have."""
    if not (machine.has("glsl") and machine.has("cuda")):
        raise Missing(f"{machine.name} has no GLSL beside CUDA")
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
    """The APIs that such records are there of; Missing when there are none."""
    machine.need(**wanted)
    devices = [name for name in ("glsl", "cuda") if machine.select(backend=name, **wanted)]
    if not devices:
        raise Missing(f"{machine.name} has no record of GLSL or CUDA in the table {wanted['table']}")
    return devices


def crossover(machine, backend, fraction):
    """The least n from which on the grid in random order beats all pairs at every size that both have, intervals
    apart; None where it does at none."""
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
    ratio: tuple  # GLSL over CUDA: middle, room below, room above
    cuda_ms: float
    source: str


def stage_ratio(kernel, glsl, cuda):
    low, high = glsl.device_stages_interval_ms[kernel]
    least, most = cuda.device_stages_interval_ms[kernel]
    if least <= 0 or low <= 0:
        return None
    middle = glsl.device_stages_ms[kernel] / cuda.device_stages_ms[kernel]
    return StageRatio(kernel, f"$n$ = {glsl.n:,}", (middle, middle - low / most, high / least - middle),
                      cuda.device_stages_ms[kernel], cuda.source)


def stage_ratios(machine):
    """Each kernel that device timers saw in both APIs in the same work of one run, where n is largest; of several such
    records the latest, and of its the one whose intervals leave the least room: a kernel may have a cheap and a dear
    part in one picture."""
    found = {}
    timed = [record for record in machine.records if {"device_stages_interval_ms", "n"} <= record.parameters.keys() and
             record.parameters.get("work") != "loop"]  # in which the spheres have moved on, not to the same places
    by_work = {(record.source, work_of(record), record.backend): record for record in timed}
    for (run, work, backend), glsl in by_work.items():
        cuda = by_work.get((run, work, "cuda"))
        if backend == "glsl" and cuda:
            for kernel in glsl.device_stages_ms.keys() & cuda.device_stages_ms.keys():
                row = stage_ratio(kernel, glsl, cuda)
                if row:
                    found.setdefault(kernel, []).append((glsl.n, glsl.date, -room(row), row))
    for kernel in sorted(found):
        yield max(found[kernel], key=lambda entry: entry[:3])[-1]


def room(row):
    """Greatest over least ratio that the intervals allow."""
    middle, below, above = row.ratio
    return (middle + above) / (middle - below)


def work_of(record):
    """What makes two records of different APIs the same work; in the grid each takes the groups that suit it."""
    names = ("table", "work", "n", "method", "exact", "order", "dt", "precision", "draw", "place",
             *(() if record.parameters.get("table") == "grid" else ("block",)))
    return (*(str(record.parameters.get(name)) for name in names), str(record.parameters.get("scene")))


def in_order(stages):
    """Each once, in the order in which they run; those that are not known come first."""
    return sorted(dict.fromkeys(stages), key=lambda name: ORDER.index(name) if name in ORDER else -1)


def stage_bars(record):
    """Kernel -> milliseconds a step; the search is `collide`, whichever its kernel."""
    return {"collide" if name.startswith("collide") else name: time for name, time in record.device_stages_ms.items()}
