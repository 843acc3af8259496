# SPDX-License-Identifier: MIT
"""Where the grid overtakes all pairs in each kind of spheres, and whether the program's own choice is the best one."""
from dataclasses import dataclass

from ranks import apart, differ
from records import Missing

FIXED = ("all pairs", "dense", "hashed")


@dataclass(frozen=True)
class Crossover:
    start: str  # the least n from which the grid stays ahead, intervals apart
    loss: str  # percent by which auto was slower than the best fixed choice at worst; 0: no difference seen
    worst: float
    source: str


def grid_ahead(ways):
    grids = [ways[name] for name in ("dense", "hashed") if name in ways]
    best = min(grids, key=lambda record: record.median)
    return "all pairs" not in ways or apart(best, ways["all pairs"]) and best.median < ways["all pairs"].median


def loss(ways):
    """Percent; 0 where auto does not differ from the best."""
    best = min((ways[name] for name in FIXED if name in ways), key=lambda record: record.median)
    auto = ways["auto"]
    return 100 * (auto.median / best.median - 1) if auto.median > best.median and differ(auto, best) else 0.0


def of_one(sizes):
    """sizes: n -> way -> record."""
    start = None
    for n in sorted(sizes, reverse=True):
        if not grid_ahead(sizes[n]):
            break
        start = n
    worst = max(loss(ways) for ways in sizes.values() if "auto" in ways)
    source = next(iter(sizes[min(sizes)].values())).source
    return Crossover(f"{start:,}" if start else "nowhere", f"{worst:.0f}", worst, source)


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
