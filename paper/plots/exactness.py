# SPDX-License-Identifier: MIT
"""The cost of the exact predicate over the naive float32 one."""
from paper.numbers.derived import cost, pairs_of
from paper.style import COLUMN, SERIES, panels, series_of

NAME = "exactness"
CAPTION = ("Cost of exactness: time with the exact predicate over time with the naive float32 one, minus "
           "1. Bars: the bounds of the cost from the intervals of both medians.")


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
