# SPDX-License-Identifier: MIT
"""Pairs that the naive predicate gets wrong, and the time of the exact one over the naive one."""
import math

from paper.plots.set_errors import source  # noqa: F401  (used by figures.py)
from paper.numbers.sets import sets
from paper.records import Missing
from paper.style import PAGE, SERIES, panels
from paper.text import APIS

NAME = "naive"
CAPTION = ("Pairs that the naive float32 predicate gets wrong (left, missed and extra pairs of the right ones) and the "
           "time of the exact one over the naive one (right; bars: the bounds from the intervals of both "
           "medians), by scene, through the grid.")


def ratio(entry):
    """Exact over naive: value, distance to the lower and to the upper bound."""
    exact, naive = entry["exact"], entry["naive"]
    (low, high), (naive_low, naive_high) = exact["interval_ms"], naive["interval_ms"]
    middle = exact["median_ms"] / naive["median_ms"]
    return middle, middle - low / naive_high, high / naive_low - middle


def cost_text(middle):
    return f"{100 * (middle - 1):+.1f} %" if middle < 2 else f"×{middle:.1f}"


def draw(machine):
    entries = sets(machine)["exactness"]
    if not entries:
        raise Missing(f"{machine.name}: the run of `spherepair sets` lacks a part")
    figure, (wrong, costs) = panels(PAGE, 0.7 + 0.15 * len(entries), 2, sharey=True)
    for place, entry in enumerate(reversed(entries)):
        look = {**SERIES[entry["backend"] if entry["backend"] != "cpu" else "cpu parallel"], "label": None}
        wrong.barh(place, entry["missed"] + entry["extra"], height=0.6, color=look["color"])
        right = f" {entry['missed']:,} missed, {entry['extra']:,} extra of {entry['right']:,}"
        wrong.text(entry["missed"] + entry["extra"], place, right, va="center", fontsize=6)
        middle, below, above = ratio(entry)
        costs.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7,
                       **{**look, "linestyle": ""})
        costs.text(1.02, place, cost_text(middle), transform=costs.get_yaxis_transform(), fontsize=6, va="center")
    wrong.set_yticks(range(len(entries)), [f"{entry['scene']}, $n$ = {entry['n']:,}, {APIS[entry['backend']]}"
                                           for entry in reversed(entries)])
    most = max(entry["missed"] + entry["extra"] for entry in entries)
    wrong.set(xscale="symlog", xlabel="pairs that the naive predicate gets wrong")
    wrong.set_xlim(0, 10 ** (1.95 * math.log10(most + 10)))
    costs.axvline(1, color="black", linewidth=0.6)
    costs.set(xscale="log", xlabel="time of the exact predicate over the naive one's")
    low, high = costs.get_xlim()
    ticks = [value for value in (0.5, 1, 2, 5, 10, 20, 50, 100, 1000) if low <= value <= high]
    costs.set_xticks(ticks, [f"{value:g}" for value in ticks])
    costs.set_xticks([], minor=True)
    for axis in (wrong, costs):
        axis.grid(axis="y", visible=False)
    return figure
