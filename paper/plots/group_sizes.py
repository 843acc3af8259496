# SPDX-License-Identifier: MIT
"""Every method and group size: the thread arrangements that the original paper varied."""
from matplotlib.ticker import FuncFormatter, NullFormatter

from paper.numbers.derived import devices_of
from paper.style import PAGE, panels, plain_ticks, plot

NAME = "group-sizes"
CAPTION = ("Time of one collision step against the group size (work-group in GLSL, block in CUDA) for the four "
           "ways to arrange the threads; the original paper's box. \\texttt{group} only tests pairs within a "
           "group.")
TITLES = {"collide_group": "group (within groups)", "collide_tiled": "tiled (one dimension)",
          "collide_square": "square (two dimensions)", "collide_triangle": "upper triangle"}


def draw(machine):
    devices = devices_of(machine)
    figure, axes = panels(PAGE, 1.9, 4)
    n = max(record.n for record in machine.need(table="methods"))
    for axis, (method, title) in zip(axes, TITLES.items()):
        for name in devices:
            rows = machine.need(table="methods", method=method, backend=name, n=n)
            plot(axis, sorted(rows, key=lambda record: record.block), name, x=lambda record: record.block)
        axis.set_xscale("log", base=2)
        axis.set_xticks([32, 64, 128, 256, 512, 1024])
        axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.tick_params(axis="x", labelrotation=45)
        axis.set_ylim(0, 1.08 * axis.get_ylim()[1])
        plain_ticks(axis)
        axis.set_title(title, loc="left")
        axis.set_xlabel("threads in a group")
    axes[0].set_ylabel("time of one step (ms)")
    axes[0].legend(loc="upper left")
    return figure
