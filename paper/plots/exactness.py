# SPDX-License-Identifier: MIT
"""What it costs to decide every pair exactly instead of by rounded float32 numbers."""
from derived import cost, pairs_of
from style import COLUMN, SERIES, panels, series_of

NAME = "exactness"
CAPTION = ("What exactness costs: time with the exact predicate over time with the naive float32 comparison, less "
           "1. Bars: the least and greatest cost that the intervals of both medians allow.")


def name(record):
    if record.backend == "cpu" and record.method != "collide_grid":
        return SERIES[series_of(record)]["label"]
    if record.backend == "cpu":
        return "CPU, grid"
    return f"{SERIES[record.backend]['label']}, {record.method.removeprefix('collide_')}"


def draw(machine):
    pairs = list(pairs_of(machine))
    figure, (axis,) = panels(COLUMN, 0.5 + 0.14 * len(pairs))
    for place, (exact, naive) in enumerate(reversed(pairs)):
        middle, low, high = cost(naive, exact)
        look = SERIES[series_of(exact)]
        axis.errorbar(middle, place, xerr=[[middle - low], [high - middle]], capsize=1.5, elinewidth=0.7,
                      **{**look, "label": None, "linestyle": ""})
    axis.set_yticks(range(len(pairs)), [name(exact) for exact, _ in reversed(pairs)])
    axis.axvline(0, color="black", linewidth=0.6)
    axis.set_xlabel(f"cost of exactness (%), $n$ = {pairs[0][0].n:,}")
    axis.grid(axis="y", visible=False)
    return figure
