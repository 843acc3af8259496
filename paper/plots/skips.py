# SPDX-License-Identifier: MIT
"""What each skip and each trick of one API is worth: the same work with it and without."""
from derived import ratio
from style import COLUMN, SERIES, panels

NAME = TABLE = "skips"
CAPTION = ("What each skip and each trick of one API saves: time without it over time with it, the results being "
           "equal. Bars: the least and greatest ratio that the intervals of both medians allow.")


def pairs_of(machine):
    """(with, without) for every trick and backend, at the largest number of spheres."""
    rows = machine.need(table=TABLE, on=True)
    largest = {(row.skip, row.backend): row.n for row in rows}  # smallest n first, so the last one stays
    for on in (row for row in rows if row.n == largest[row.skip, row.backend]):
        wanted = {name: on.parameters[name] for name in ("skip", "backend", "n")}
        yield on, machine.one(table=TABLE, on=False, scene=on.scene["name"], **wanted)


def draw(machine):
    pairs = list(pairs_of(machine))
    figure, (axis,) = panels(COLUMN, 0.7 + 0.16 * len(pairs))
    for place, (on, off) in enumerate(reversed(pairs)):
        middle, below, above = ratio(off, on)
        look = SERIES[on.backend if on.backend != "cpu" else "cpu parallel"]
        axis.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7,
                      **{**look, "label": None, "linestyle": ""})
    axis.set_yticks(range(len(pairs)), [f"{on.backend} {on.skip}, n = {on.n:,}" for on, _ in reversed(pairs)])
    axis.axvline(1, color="black", linewidth=0.6)
    axis.set_xlabel("time without / time with")
    axis.grid(axis="y", visible=False)
    return figure
