# SPDX-License-Identifier: MIT
"""Which API is faster at all pairs, as sentences whose form and numbers follow from the records."""
from dataclasses import dataclass

from paper.numbers.derived import matched
from paper.numbers.ratios import Ratio, family
from paper.records import Missing

CONTESTS = {"all pairs of the original's box": {"table": "scale", "scene": "random"},
            "all pairs of a gas": {"table": "scale", "scene": "uniform"},
            "whole steps": {"table": "step"}}
NAMES = {"opengl": "OpenGL", "cuda": "CUDA"}
LARGE = 65536  # spheres from which launches are negligible


@dataclass(frozen=True)
class Contest:
    n: int
    winner: str  # glsl or cuda; empty if undecided
    source: str
    where: str
    compared: Ratio

    @property
    def ratio(self):
        """OpenGL's time over CUDA's."""
        return self.compared.middle


def decided(pairs, where=()):
    """The contests of one family, with the kind of work of each."""
    return [Contest(glsl.n, ("cuda" if ratio.middle > 1 else "opengl") if ratio.decided else "", glsl.source, kind, ratio)
            for (glsl, cuda), ratio, kind in zip(pairs, family(pairs), where or [""] * len(pairs))]


def contests(machine):
    """Those of several processes."""
    pairs = [(where, pair) for where, wanted in CONTESTS.items() for pair in matched(machine, **wanted)]
    found = [entry for entry in decided([pair for _, pair in pairs], [where for where, _ in pairs]) if entry.compared.processes > 1]
    if not any(entry.n >= LARGE for entry in found):
        raise Missing(f"{machine.name}: all pairs of {LARGE:,} spheres and more were not timed in both APIs in several processes")
    return found


def won(found, name):
    return [entry for entry in found if entry.winner == name]


def ratios(found):
    """OpenGL's time over CUDA's: 1.05x to 1.8x, or only 1.05x."""
    least, most = (f"{bound(entry.ratio for entry in found):.2f}x" for bound in (min, max))
    return least if least == most else f"{least} to {most}"


def sizes(found):
    words = [f"{n:,}" for n in sorted({entry.n for entry in found})]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def in_order(found):
    """(winner below, winner above) if a number of spheres separates them, otherwise None."""
    for low, high in (("cuda", "opengl"), ("opengl", "cuda")):
        below, above = won(found, low), won(found, high)
        if below and above and max(entry.n for entry in below) < min(entry.n for entry in above):
            return low, high
    return None


def by_size(found):
    """Time ratio and range of sizes; None if no order of sizes separates the winners."""
    sides = in_order(found)
    if sides:
        low, high = (won(found, name) for name in sides)
        return (f"OpenGL takes {ratios(low)} CUDA's time up to {max(e.n for e in low):,} spheres and {ratios(high)} from "
                f"{min(e.n for e in high):,} on")
    alone = [name for name in NAMES if won(found, name)]
    if len(alone) > 1:
        return None
    if not alone:
        return "no difference is decided"
    mine = won(found, alone[0])
    throughout = "at every size" if len(mine) == len(found) else f"in {len(mine)} of {len(found)} contests"
    return f"OpenGL takes {ratios(mine)} CUDA's time {throughout}"


def by_scene(found):
    """The same per kind of work, grouped where only one API wins; None if that does not separate the winners."""
    kinds = {}
    for entry in found:
        kinds.setdefault(entry.where, []).append(entry)
    if any(by_size(entries) is None for entries in kinds.values()):
        return None
    together = {}
    for where, entries in kinds.items():
        winners = {entry.winner for entry in entries}
        together.setdefault(winners.pop() if len(winners) == 1 else where, {})[where] = entries
    clauses = [f"in {' and in '.join(group)} {by_size([entry for entries in group.values() for entry in entries])}"
               for group in together.values()]
    return "; ".join(clauses)


def by_count(found):
    names = sorted((name for name in NAMES if won(found, name)), key=lambda name: -len(won(found, name)))
    first, *others = (f"{ratios(won(found, name))}{{}} in {len(won(found, name))}" for name in names)
    return f"of {len(found)} contests, OpenGL takes " + " and ".join([first.format(" CUDA's time"), *(text.format("") for text in others)])


def wins(found):
    """Time ratios and sizes, in the shortest form that the records allow."""
    open_ones = won(found, "")
    rest = f"; at {sizes(open_ones)} spheres it is undecided" if 0 < len(open_ones) < len(found) else ""
    return (by_size(found) or by_scene(found) or by_count(found)) + rest


def headline(found):
    """In one clause."""
    winners = {entry.winner for entry in found}
    if winners == {""}:
        return "no difference is decided"
    if {"opengl", "cuda"} <= winners:
        return "neither API wins throughout"
    name = NAMES[max(winners)]
    return f"{name} is never the slower" if "" in winners else f"{name} wins throughout"


def at_large_sizes(found):
    """At sizes at which launches are negligible."""
    large = [entry for entry in found if entry.n >= LARGE]
    mine = sorted(((NAMES[name], won(large, name)) for name in NAMES if won(large, name)),
                  key=lambda item: -len(item[1]))
    if not mine:
        return f"in none of {len(large)} contests of {LARGE:,} spheres and more a difference is decided"
    (name, first), *other = mine
    rest = f", and {other[0][0]}'s in {len(other[0][1])} ({ratios(other[0][1])})" if other else ""
    return (f"in {len(first)} of {len(large)} contests of {LARGE:,} spheres and more {name}'s compiler made the faster "
            f"code (OpenGL takes {ratios(first)} CUDA's time){rest}")
