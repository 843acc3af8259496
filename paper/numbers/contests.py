# SPDX-License-Identifier: MIT
"""Every contest of GLSL against CUDA among the records of whole work, by the duration of CUDA's step."""
import statistics
from dataclasses import dataclass

from paper.numbers.ranks import apart, paired, time_ratio
from paper.records import Missing

TABLES = ("table1", "methods", "arrangements", "scale", "step", "exactness", "crossover", "grid", "precision", "draw")
SHARED = ("source", "table", "work", "n", "method", "exact", "order", "kind", "way", "dt", "precision", "draw", "place", "scene")
OWN_BLOCK = ("grid", "crossover")  # tables in which each API uses its own group size
BOUNDS = (7, 10, 15, 30, 100, 1000)  # of the bins, microseconds
LEVEL = 1.2  # of medians: below it the API hardly matters
WORDS = {"motion": "motion, one launch a step"}


@dataclass(frozen=True)
class Contest:
    work: str  # all pairs, grid, motion or drawing
    cuda_us: float
    ratio: float  # of GLSL's time to CUDA's
    apart: bool  # its interval is on one side of 1
    same_steps: bool  # both took as many steps a sample
    source: str


def work_of(record):
    values = record.parameters
    if record.table == "draw":
        return "drawing"
    if record.table == "precision" or values.get("work") == "move":
        return "motion"
    by_grid = "collide_grid" in (values.get("method"), values.get("choice", {}).get("name"))
    return "grid" if by_grid else "all pairs"


def key_of(record):
    values = {"source": record.source, **record.parameters}
    block = None if record.table in OWN_BLOCK else values.get("block")
    return (*(str(values.get(name)) for name in SHARED), str(block))


def contest(glsl, cuda):
    same_steps = paired(glsl, cuda) or glsl.parameters.get("batch") == cuda.parameters.get("batch")
    return Contest(work_of(cuda), 1e3 * cuda.median, time_ratio(glsl, cuda)[0], apart(glsl, cuda), same_steps,
                   cuda.source)


def contests(machine):
    """The shortest step first. Drawing by the compute rasteriser alone: through OpenGL, CUDA's spheres are transferred."""
    by_work = {}
    for record in (record for table in TABLES for record in machine.select(table=table)):
        if record.backend in ("glsl", "cuda") and record.parameters.get("draw", "compute") == "compute":
            by_work.setdefault(key_of(record), {}).setdefault(record.backend, []).append(record)
    found = [contest(each["glsl"][0], each["cuda"][0]) for each in by_work.values()
             if {name: len(rows) for name, rows in each.items()} == {"glsl": 1, "cuda": 1}]
    if not found:
        raise Missing(f"{machine.name} has no work that was timed in both GLSL and CUDA")
    return sorted(found, key=lambda entry: entry.cuda_us)


@dataclass(frozen=True)
class Bin:
    low: float  # microseconds; 0: without a lower bound
    high: float
    contests: tuple

    @property
    def median(self):
        return statistics.median(entry.ratio for entry in self.contests)


def bins(found):
    edges = (0, *BOUNDS, float("inf"))
    made = [Bin(low, high, tuple(entry for entry in found if low <= entry.cuda_us < high))
            for low, high in zip(edges, edges[1:])]
    return [each for each in made if each.contests]


def duration(microseconds):
    return f"{microseconds / 1000:g} ms" if microseconds >= 1000 else f"{microseconds:g} µs"


def split(made):
    """(bins of short steps, of long ones): all medians are LEVEL or more in the first, and below it in the others. None
    where no duration separates them."""
    short = [each.median >= LEVEL for each in made]
    first = short.index(False) if False in short else 0
    return (made[:first], made[first:]) if first and not any(short[first:]) else None


def span(values):
    least, most = (f"{bound(values):.2f}x" for bound in (min, max))
    return least if least == most else f"{least} to {most}"


def exception(found, limit):
    """Of the short steps, those with a ratio below 1: how many, of what work if of one, and who leads in them."""
    below = [entry for entry in found if entry.cuda_us < limit and entry.ratio < 1]
    if not below:
        return ""
    led = sum(entry.apart for entry in below)
    works = {entry.work for entry in below}
    work = f" of {WORDS.get(*works, *works)}" if len(works) == 1 else ""
    return (f" ({f'GLSL leads in {led} of' if led else 'neither leads in'} {len(below)} "
            f"contest{'s' * (len(below) > 1)}{work}: {span([entry.ratio for entry in below])})")


def rule(machine):
    """What a programmer can do about it."""
    found = contests(machine)
    made = bins(found)
    if split(made) is None:
        medians = ", ".join(f"{each.median:.2f}x" for each in made)
        return (f"In {len(found)} recorded contests the duration of a step does not separate large ratios from small ones: GLSL "
                f"takes {medians} CUDA's time, from the shortest steps to the longest (medians of bins).")
    below, above = split(made)
    limit = above[0].low
    return (f"In {len(found)} recorded contests the ratio falls with the duration of a step: below {duration(limit)} GLSL takes "
            f"{span([each.median for each in below])} CUDA's time{exception(found, limit)}, above it "
            f"{span([each.median for each in above])} (medians of bins). So merge or batch launches until a step lasts that "
            "long; then choose the API by what else it offers.")
