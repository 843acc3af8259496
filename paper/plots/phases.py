# SPDX-License-Identifier: MIT
"""The time of all pairs by kernel: one collision step by device timers."""
from itertools import cycle

from paper.numbers.derived import in_order, stage_bars
from paper.records import Missing
from paper.style import COLUMN, panels
from paper.text import APIS

NAME = "phases"
CAPTION = ("A collision step's time by kernel, from device timers (GL timer queries, CUDA "
           "events), groups of 128. The timers serialise the kernels, so the sum exceeds the host's time of "
           "back-to-back steps (black mark).")
LOOKS = [("#d9d9d9", ""), ("#4f6d9e", ""), ("#e0b080", "///"), ("#9dbf8d", "..."), ("#777777", "xxx"), ("#ffffff", ""),
         ("#b5c7e3", "\\\\\\"), ("#f2d9bf", "---"), ("#555555", ""), ("#c9dfc0", "+++"), ("#eeeeee", "ooo"),
         ("#8a6f4d", "")]


def draw_bars(axis, rows, names, scale):
    """One bar per record, divided into its kernels; `scale` converts milliseconds to the unit of the axis."""
    stages = in_order(stage for record in rows for stage in stage_bars(record))
    for place, record in enumerate(reversed(rows)):
        left = 0.0
        for (color, hatch), stage in zip(cycle(LOOKS), stages):
            width = scale(record) * stage_bars(record).get(stage, 0.0)
            axis.barh(place, width, 0.7, left=left, color=color, hatch=hatch, edgecolor="black", linewidth=0.3,
                      label=stage if place == 0 else None)
            left += width
        axis.plot([scale(record) * record.median] * 2, [place - 0.42, place + 0.42], color="black", linewidth=1.2)
    axis.set_yticks(range(len(rows)), list(reversed(names)))
    axis.grid(axis="y", visible=False)
    return stages


def draw(machine):
    rows = [record for method in ("collide_square", "collide_triangle") for name in ("opengl", "cuda")
            for record in machine.select(table="methods", method=method, backend=name, block=128)
            if record.parameters.get("device_stages_ms")]
    if not rows:
        raise Missing(f"{machine.name} has no device timers")
    figure, (axis,) = panels(COLUMN, 0.75 + 0.17 * len(rows))
    names = [f"{APIS[record.backend]} {record.method.removeprefix('collide_')}" for record in rows]
    stages = draw_bars(axis, rows, names, lambda record: 1e3)
    axis.set_xlabel(f"time (µs), $n$ = {rows[0].n:,}")
    axis.legend(loc="upper center", bbox_to_anchor=(0.4, 1.28), ncols=len(stages), handlelength=1.2, columnspacing=1.0)
    return figure
