# SPDX-License-Identifier: MIT
"""From how many spheres on the grid is faster than all pairs, per kind of spheres, and how good the automatic choice is."""
from dataclasses import dataclass

from paper.numbers.ratios import family
from paper.records import Missing

GRIDS = ("dense", "hashed")  # the other ways, except auto, test all pairs


@dataclass(frozen=True)
class Crossover:
    start: str  # the least n from which the grid stays faster
    loss: str  # greatest ratio of auto to the best fixed choice; 1: undecided
    losses: tuple  # the same for each n
    source: str


def fastest(ways, grid=None):
    """Of the fixed ways; grid: only those with or without a grid. None if there is none."""
    fixed = [record for way, record in ways.items() if way != "auto" and grid in (None, way in GRIDS)]
    return min(fixed, key=lambda record: record.median, default=None)


def grid_faster(sizes):
    """n -> whether the grid is; also where all pairs were stopped because they took too long. One family."""
    best = {n: (fastest(ways, True), fastest(ways, False)) for n, ways in sizes.items()}
    both = {n: pair for n, pair in best.items() if all(pair)}
    compared = dict(zip(both, family(list(both.values()))))
    return {n: grid is not None and (pairs is None or compared[n].decided and compared[n].middle < 1)
            for n, (grid, pairs) in best.items()}


def chosen(choice):
    """The fixed way that auto chose."""
    name = choice.get("cells", choice["name"])
    return f"{name}/{choice['block']}" if name == "collide_square" else name


def losses_of(sizes):
    """Auto's time over the best of each size; 1 if they are undecided or the same way. One family."""
    pairs = [(ways["auto"], fastest(ways)) for _, ways in sorted(sizes.items()) if "auto" in ways and fastest(ways)]
    same = [chosen(auto.choice) == best.way for auto, best in pairs]
    compared = iter(family([pair for pair, alike in zip(pairs, same) if not alike]))
    return tuple(1.0 if alike else loss(next(compared)) for alike in same)


def loss(ratio):
    return ratio.middle if ratio.decided and ratio.middle > 1 else 1.0


def of_one(sizes):
    """sizes: n -> way -> record."""
    start, faster = None, grid_faster(sizes)
    for n in sorted(sizes, reverse=True):
        if not faster[n]:
            break
        start = n
    losses = losses_of(sizes)
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
