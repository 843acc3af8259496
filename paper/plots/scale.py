# SPDX-License-Identifier: MIT
"""All pairs from small to large n: time with its slope, and the share of the instruction floor."""
import math

from paper.numbers.derived import devices_of, INSTRUCTIONS, issue_rate, share_of_floor, slope
from paper.style import PAGE, SERIES, panels, plain_ticks, plot, spheres_axis

NAME = "scale"
CAPTION = ("All pairs by the upper triangle, groups of 128, from {first:,} to {last:,} spheres. (a) Time of one "
           "collision step; the numbers are the slope between neighbouring sizes (2 is quadratic). "
           "(b) The rate of tested pairs, as a share of the issue floor: ${rate:.2f} \\cdot 10^{{13}}$ "
           "lane-instructions per second over {per_pair} instructions per pair.")
SCENES = {"random": ("the original paper's box", "-", 1.0), "uniform": ("gas of packing fraction 0.3", ":", 0.6)}


def caption(machine):
    rows = machine.need(table="scale")
    return CAPTION.format(first=rows[0].n, last=rows[-1].n, rate=issue_rate(machine) / 1e13, per_pair=INSTRUCTIONS)


def note_slopes(axis, rows):
    for small, large in zip(rows[1:], rows[2:]):  # at smaller sizes launches dominate
        middle = math.sqrt(small.n * large.n), math.sqrt(small.median * large.median)
        axis.annotate(f"{slope(small, large):.2f}", middle, xytext=(5, -7), textcoords="offset points", fontsize=6)


def draw(machine):
    devices = devices_of(machine)
    with_floor = machine.has("cuda")
    figure, axes = panels(PAGE if with_floor else PAGE / 2, 2.2, 2 if with_floor else 1)
    for scene, (title, line, alpha) in SCENES.items():
        for name in devices:
            rows = machine.need(table="scale", scene=scene, backend=name)
            look = {"label": f"{SERIES[name]['label']}, {title}", "linestyle": line, "alpha": alpha}
            plot(axes[0], rows, name, **look)
            if with_floor:
                shares = [share_of_floor(machine, record) for record in rows]
                axes[1].plot([record.n for record in rows], shares, **{**SERIES[name], **look})
    note_slopes(axes[0], machine.need(table="scale", scene="random", backend=devices[-1]))
    axes[0].set_yscale("log")
    plain_ticks(axes[0])
    axes[0].set_ylabel("time of one step (ms)")
    axes[0].legend(loc="upper left")
    axes[0].set_title("(a)", loc="left")
    if with_floor:
        axes[1].set_ylabel("share of the issue floor (%)")
        axes[1].set_ylim(0, 100)
        axes[1].set_title("(b)", loc="left")
    for axis in axes:
        spheres_axis(axis)
    return figure
