# SPDX-License-Identifier: MIT
"""Each kernel against its twin, by the device's own timers."""
from derived import stage_ratios
from records import Missing
from style import PAGE, panels, time_text

NAME = "kernel-pairs"
CAPTION = ("Each kernel against its twin by the device's own timers (GL timer queries, CUDA events), at the largest "
           "size that was recorded of it: GLSL's time over CUDA's, above 1 CUDA leads. Bars: the least and greatest "
           "ratio that the intervals of both medians allow. On the right: CUDA's time.")


def source(machine):
    """Kernels may come from several runs."""
    return machine.short.replace(machine.id, ", ".join(dict.fromkeys(row.source for row in stage_ratios(machine))))


def draw(machine):
    rows = list(stage_ratios(machine))
    if not rows:
        raise Missing(f"{machine.name} has no kernel with device times and their intervals through both APIs")
    figure, (axis,) = panels(PAGE, 0.7 + 0.15 * len(rows))
    for place, row in enumerate(reversed(rows)):
        middle, below, above = row.ratio
        axis.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7, marker="o", color="#15396b")
        axis.text(1.01, place, time_text(row.cuda_ms), transform=axis.get_yaxis_transform(), fontsize=6,
                  va="center")
    axis.axvline(1, color="black", linewidth=0.7)
    axis.set_xlim(left=0)
    axis.set_yticks(range(len(rows)), [f"{row.kernel}, {row.where}" for row in reversed(rows)])
    axis.set_xlabel("GLSL time / CUDA time")
    axis.grid(axis="y", visible=False)
    return figure
