# SPDX-License-Identifier: MIT
"""From how many spheres on the grid is faster than all pairs, per kind of spheres, and how good the automatic choice is."""
from dataclasses import dataclass

from paper.numbers.ranks import differ
from paper.records import Missing

GRIDS = ("dense", "hashed")  # the other ways, except auto, test all pairs


@dataclass(frozen=True)
class Crossover:
    start: str  # the least n from which the grid stays faster, by intervals or the rank test
    loss: str  # greatest ratio of auto to the best fixed choice; 1: no difference seen
    losses: tuple  # the same for each n
    source: str


def fastest(ways, grid=None):
    """Of the fixed ways; grid: only those with or without a grid. None if there is none."""
    fixed = [record for way, record in ways.items() if way != "auto" and grid in (None, way in GRIDS)]
    return min(fixed, key=lambda record: record.median, default=None)


def grid_faster(ways):
    """Also if all pairs were stopped because they took too long."""
    grid, pairs = fastest(ways, True), fastest(ways, False)
    return grid is not None and (pairs is None or differ(grid, pairs) and grid.median < pairs.median)


def chosen(choice):
    """The fixed way that auto chose."""
    name = choice.get("cells", choice["name"])
    return f"{name}/{choice['block']}" if name == "collide_square" else name


def loss(ways):
    """Auto's time over the best; 1 if the two do not differ or are the same way."""
    best, auto = fastest(ways), ways["auto"]
    if chosen(auto.choice) == best.way:
        return 1.0
    return auto.median / best.median if auto.median > best.median and differ(auto, best) else 1.0


def of_one(sizes):
    """sizes: n -> way -> record."""
    start = None
    for n in sorted(sizes, reverse=True):
        if not grid_faster(sizes[n]):
            break
        start = n
    losses = tuple(loss(ways) for _, ways in sorted(sizes.items()) if "auto" in ways and fastest(ways))
    source = next(iter(sizes[min(sizes)].values())).source
    return Crossover(f"{start:,}" if start else "nowhere", f"{max(losses):.2g}", losses, source)


def crossovers_by_kind(machine):
    """kind of spheres -> backend -> Crossover."""
    found = {}
    for record in machine.need(table="crossover"):
        sizes = found.setdefault(record.kind, {}).setdefault(record.backend, {})
        ways = sizes.setdefault(record.n, {})
        if record.way in ways:
            raise Missing(f"{machine.name} has two records of {record.label}")
        ways[record.way] = record
    return {kind: {name: of_one(sizes) for name, sizes in by_backend.items()} for kind, by_backend in found.items()}
