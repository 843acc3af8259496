# SPDX-License-Identifier: MIT
"""What exactness corrects beside what it costs: pairs that the naive predicate gets wrong, and the times of both."""
import math

from plots.set_errors import source  # noqa: F401  (what stands under the figure)
from records import Missing
from sets import sets
from style import PAGE, SERIES, panels

NAME = "naive"
CAPTION = ("What the naive float32 predicate gets wrong (left, missed and extra pairs of the right ones) and what the "
           "exact one costs over it (right; bars: the least and greatest cost that the intervals of both medians "
           "allow), by scene.")

NAMES = {"cpu": "CPU", "glsl": "GLSL", "cuda": "CUDA"}


def cost(entry):
    """Percent: middle, and how far the bars reach below and above."""
    exact, naive = entry["exact"], entry["naive"]
    (low, high), (naive_low, naive_high) = exact["interval_ms"], naive["interval_ms"]
    middle = 100 * (exact["median_ms"] / naive["median_ms"] - 1)
    return middle, middle - 100 * (low / naive_high - 1), 100 * (high / naive_low - 1) - middle


def draw(machine):
    entries = sets(machine)["exactness"]
    if not entries:
        raise Missing(f"{machine.name}: the run of `spherepair sets` lacks a part")
    figure, (wrong, costs) = panels(PAGE, 0.8 + 0.17 * len(entries), 2, sharey=True)
    for place, entry in enumerate(reversed(entries)):
        look = {**SERIES[entry["backend"] if entry["backend"] != "cpu" else "cpu parallel"], "label": None}
        wrong.barh(place, entry["missed"] + entry["extra"], height=0.6, color=look["color"])
        right = f" {entry['missed']:,} missed, {entry['extra']:,} extra of {entry['right']:,}"
        wrong.text(entry["missed"] + entry["extra"], place, right, va="center", fontsize=6)
        middle, below, above = cost(entry)
        costs.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7,
                       **{**look, "linestyle": ""})
    labels = [f"{entry['scene']}, $n$ = {entry['n']:,}, {NAMES[entry['backend']]}" for entry in reversed(entries)]
    wrong.set_yticks(range(len(entries)), labels)
    most = max(entry["missed"] + entry["extra"] for entry in entries)
    wrong.set(xscale="symlog", xlabel="pairs that the naive predicate gets wrong")
    wrong.set_xlim(0, 10 ** (2.2 * math.log10(most + 10)))
    costs.axvline(0, color="black", linewidth=0.6)
    costs.set_xlabel("cost of the exact predicate (%)")
    for axis in (wrong, costs):
        axis.grid(axis="y", visible=False)
    return figure
