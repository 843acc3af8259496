# SPDX-License-Identifier: MIT
"""Every contest of OpenGL against CUDA among the records of whole work, by kind of work. Those of one kind are shown
together, so they are one family for Holm's correction."""
import statistics
from dataclasses import dataclass

from paper.numbers.ratios import Ratio, family, in_turns
from paper.records import Missing

TABLES = ("table1", "methods", "arrangements", "scale", "step", "exactness", "crossover", "grid", "precision", "draw", "contact_runs",
          "contact_sums", "gas_steps")
SHARED = ("source", "table", "work", "n", "method", "exact", "order", "kind", "way", "dt", "precision", "draw", "place", "scene", "law",
          "restitution", "sums", "steps_a_contact")
OWN_BLOCK = ("grid", "crossover")  # tables in which each API uses its own group size
KINDS = ("all pairs", "grid", "motion", "drawing", "contacts")  # whole steps are by all pairs
SHORT = 4096  # spheres of a step whose time is mostly launches
SCENES = {"one_cell": "all spheres in one cell", "radii": "unequal radii", "clusters": "dense clusters", "thin": "a thin layer",
          "box": "the original box", "gas": "a gas"}


@dataclass(frozen=True)
class Contest:
    work: str  # one of KINDS
    what: str  # the method and the spheres
    n: int
    cuda_us: float
    ratio: Ratio  # of OpenGL's time to CUDA's, decided among the contests of its kind
    same_steps: bool  # both took as many steps a sample
    source: str
    table: str


def work_of(record):
    values = record.parameters
    if record.table == "draw":
        return "drawing"
    if record.table.startswith(("contact_", "gas_")):
        return "contacts"
    if record.table == "precision" or values.get("work") == "move":
        return "motion"
    by_grid = "collide_grid" in (values.get("method"), values.get("choice", {}).get("name")) or values.get("way") in ("dense", "hashed")
    return "grid" if by_grid else "all pairs"


def what_of(record):
    """E.g. triangle, all spheres in one cell."""
    values = record.parameters
    method = values.get("way") or values.get("method") or values.get("work") or f"sums: {values.get('sums', 'integers')}"
    parts = [method.removeprefix("collide_").replace("_", " "), SCENES.get(values.get("kind"), "")]
    return ", ".join(filter(None, parts))


def key_of(record):
    values = {"source": record.source, **record.parameters}
    block = None if record.table in OWN_BLOCK else values.get("block")
    return (*(str(values.get(name)) for name in SHARED), str(block))


def pairs_of(machine):
    """Drawing by the compute rasteriser alone: through OpenGL, CUDA's spheres are transferred."""
    by_work = {}
    for record in (record for table in TABLES for record in machine.select(table=table)):
        if record.backend in ("opengl", "cuda") and record.parameters.get("draw", "compute") == "compute":
            by_work.setdefault(key_of(record), {}).setdefault(record.backend, []).append(record)
    return [(each["opengl"][0], each["cuda"][0]) for each in by_work.values()
            if {name: len(rows) for name, rows in each.items()} == {"opengl": 1, "cuda": 1}]


def contest(glsl, cuda, ratio):
    same_steps = in_turns(glsl, cuda) or glsl.parameters.get("batch") == cuda.parameters.get("batch")
    return Contest(work_of(cuda), what_of(cuda), cuda.n, 1e3 * cuda.median, ratio, same_steps, cuda.source, cuda.table)


def contests(machine):
    """By kind of work, then by size."""
    pairs, found = pairs_of(machine), []
    for kind in KINDS:
        own = sorted((pair for pair in pairs if work_of(pair[1]) == kind), key=lambda pair: pair[1].n)
        found += [contest(*pair, ratio) for pair, ratio in zip(own, family(own))]
    if not found:
        raise Missing(f"{machine.name} has no work that was timed in both OpenGL and CUDA")
    return found


def several(found):
    """Those of several processes, which alone say something of other processes."""
    return [entry for entry in found if entry.ratio.processes > 1]


def decided(found):
    """(those in which CUDA takes less time, those in which OpenGL does)."""
    clear = [entry for entry in found if entry.ratio.decided]
    return [entry for entry in clear if entry.ratio.middle > 1], [entry for entry in clear if entry.ratio.middle < 1]


def extremes(found):
    """(least, greatest) ratio of those that are decided in several processes; Missing without any."""
    clear = [entry for side in decided(several(found)) for entry in side]
    if not clear:
        raise Missing("no contest is decided in several processes")
    return tuple(bound(clear, key=lambda entry: entry.ratio.middle) for bound in (min, max))


def ratio_span(found):
    least, most = (f"{bound(entry.ratio.middle for entry in found):.2f}x" for bound in (min, max))
    return least if least == most else f"{least} to {most}"


def short_steps(machine):
    """Whole steps of few spheres in several processes, where launches are most of the time."""
    found = [entry for entry in several(contests(machine)) if entry.table == "step" and entry.n <= SHORT]
    if not found:
        raise Missing(f"{machine.name} has no whole steps of up to {SHORT:,} spheres of several processes")
    return found


@dataclass(frozen=True)
class Plain:
    """What the plain means of the longest batches change, against the fitted slopes."""
    contests: int
    percent: float  # median change of a ratio
    widest: float  # greatest change
    flips: int  # ratios that fall on the other side of 1
    decided_flips: int


def plain_means(found):
    known = [entry for entry in found if entry.ratio.plain]
    if not known:
        raise Missing("no contest has batches")
    changes = [100 * abs(entry.ratio.plain / entry.ratio.middle - 1) for entry in known]
    flipped = [entry for entry in known if (entry.ratio.plain - 1) * (entry.ratio.middle - 1) < 0]
    return Plain(len(known), statistics.median(changes), max(changes), len(flipped), sum(entry.ratio.decided for entry in flipped))
