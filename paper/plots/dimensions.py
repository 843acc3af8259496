# SPDX-License-Identifier: MIT
"""The original paper's question about one and two dimensions: a double loop or a single one."""
import numpy

from derived import best
from records import Missing
from style import COLUMN, SERIES, panels, plain_ticks

NAME = "dimensions"
CAPTION = ("What the arrangement is worth: best group size of each method, all groups against all groups. "
           "\\texttt{tiled} is the original paper's one-dimensional double loop, \\texttt{square} its "
           "two-dimensional single loop, \\texttt{triangle} meets each pair once.")
METHODS = ("collide_tiled", "collide_square", "collide_triangle")


def draw(machine):
    devices = [name for name in ("glsl", "cuda") if machine.has(name)]
    if not devices:
        raise Missing(f"{machine.name} was run without GLSL and CUDA")
    figure, (axis,) = panels(COLUMN, 2.0)
    width = 0.8 / len(devices)
    for k, name in enumerate(devices):
        rows = [best(machine, name, method) for method in METHODS]
        places = numpy.arange(len(METHODS)) + (k - (len(devices) - 1) / 2) * width
        bars = axis.bar(places, [r.median for r in rows], width * 0.92, color=SERIES[name]["color"],
                        yerr=[[r.median - r.low for r in rows], [r.high - r.median for r in rows]],
                        error_kw={"elinewidth": 0.6, "capsize": 1.5}, label=SERIES[name]["label"],
                        hatch="" if name == "glsl" else "///", edgecolor="white", linewidth=0.3)
        axis.bar_label(bars, [f"{r.median:.3g}\n({r.block})" for r in rows], padding=1, fontsize=5.5)
    axis.set_yscale("log")
    axis.set_ylim(top=axis.get_ylim()[1] * 3)
    plain_ticks(axis)
    axis.grid(axis="x", visible=False)
    axis.set_xticks(range(len(METHODS)), [name.removeprefix("collide_") for name in METHODS])
    axis.set_ylabel("time of one step (ms)")
    axis.set_xlabel(f"method, $n$ = {rows[0].n:,} (best group size in brackets)")
    axis.legend(loc="upper right")
    return figure
