# SPDX-License-Identifier: MIT
"""The original paper's arrangements in one and two dimensions: a double or a single loop."""
from paper.numbers.derived import best, devices_of
from paper.style import COLUMN, panels, plain_ticks, plot

NAME = "dimensions"
CAPTION = ("Time of each arrangement at its best group size, all groups against all groups. "
           "\\texttt{tiled} is the original paper's one-dimensional double loop, \\texttt{square} its "
           "two-dimensional single loop, \\texttt{triangle} tests each pair once.")
METHODS = ("collide_tiled", "collide_square", "collide_triangle")


def draw(machine):
    devices = devices_of(machine)
    figure, (axis,) = panels(COLUMN, 2.0)
    for k, name in enumerate(devices):
        rows = [best(machine, name, method) for method in METHODS]
        positions = [index + 0.16 * (2 * k - 1) for index in range(len(METHODS))]
        plot(axis, rows, name, x=lambda row: positions[METHODS.index(row.method)], linestyle="")
        for position, row in zip(positions, rows):
            axis.annotate(f"{row.median:.3g} ({row.block})", (position, row.median), xytext=(0, -5 if k else 5),
                          textcoords="offset points", ha="center", va="top" if k else "bottom", fontsize=6)
    axis.set_yscale("log")
    axis.set_xlim(-0.5, len(METHODS) - 0.5)
    low, high = axis.get_ylim()
    axis.set_ylim(low / 1.6, 1.6 * high)
    plain_ticks(axis)
    axis.grid(axis="x", visible=False)
    axis.set_xticks(range(len(METHODS)), [name.removeprefix("collide_") for name in METHODS])
    axis.set_ylabel("time of one step (ms)")
    axis.set_xlabel(f"method, $n$ = {rows[0].n:,} (best group size in brackets)")
    axis.legend(loc="upper right")
    return figure
