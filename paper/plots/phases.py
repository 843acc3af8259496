# SPDX-License-Identifier: MIT
"""Where the time goes: the kernels of one collision step by the device's own timer."""
from records import Missing
from style import COLUMN, panels

NAME = "phases"
CAPTION = ("Where a collision step's time goes: its kernels by the device's own timer (GL timer queries, CUDA "
           "events), groups of 128. The timers serialise the kernels, so the sum exceeds the host's time of "
           "back-to-back steps (black mark).")
GREYS = ["#d9d9d9", "#4f6d9e", "#e0b080", "#9dbf8d", "#777777", "#ffffff"]
HATCHES = ["", "", "///", "...", "xxx", ""]


def phases(record):
    return {"collide" if name.startswith("collide") else name: time for name, time in record.device_stages_ms.items()}


def draw(machine):
    rows = [record for method in ("collide_square", "collide_triangle") for name in ("glsl", "cuda")
            for record in machine.select(table="methods", method=method, backend=name, block=128)
            if record.parameters.get("device_stages_ms")]
    if not rows:
        raise Missing(f"{machine.name} has no device timers")
    stages = list(dict.fromkeys(stage for record in rows for stage in phases(record)))
    figure, (axis,) = panels(COLUMN, 0.75 + 0.17 * len(rows))
    for place, record in enumerate(reversed(rows)):
        left = 0.0
        for k, stage in enumerate(stages):
            width = 1e3 * phases(record).get(stage, 0.0)
            axis.barh(place, width, 0.7, left=left, color=GREYS[k % 6], hatch=HATCHES[k % 6], edgecolor="black",
                      linewidth=0.3, label=stage if place == 0 else None)
            left += width
        axis.plot([1e3 * record.median] * 2, [place - 0.42, place + 0.42], color="black", linewidth=1.2)
    names = [f"{record.backend.upper()} {record.method.removeprefix('collide_')}" for record in reversed(rows)]
    axis.set_yticks(range(len(rows)), names)
    axis.set_xlabel(f"time (µs), $n$ = {rows[0].n:,}")
    axis.grid(axis="y", visible=False)
    axis.legend(loc="upper center", bbox_to_anchor=(0.4, 1.28), ncols=len(stages), handlelength=1.2, columnspacing=1.0)
    return figure
