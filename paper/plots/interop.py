# SPDX-License-Identifier: MIT
"""The cost of transferring spheres from CUDA to OpenGL."""
from paper.style import COLUMN, panels

NAME = TABLE = "interop"
CAPTION = ("Transferring the spheres from CUDA to OpenGL, with a wait after each: time of each way to share their memory, "
           "with the interval of the median.")


def draw(machine):
    rows = machine.need(table=TABLE)
    figure, (axis,) = panels(COLUMN, 0.7 + 0.17 * len(rows))
    for place, row in enumerate(reversed(rows)):
        axis.errorbar(1e3 * row.median, place, xerr=[[1e3 * (row.median - row.low)], [1e3 * (row.high - row.median)]],
                      capsize=1.5, elinewidth=0.7, marker="o", color="#15396b")
    axis.set_yticks(range(len(rows)), [f"{row.way}, $n$ = {row.n:,}" for row in reversed(rows)])
    axis.set_xscale("log")
    axis.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.set_xlabel("time of one transfer (µs)")
    axis.grid(axis="y", visible=False)
    return figure
