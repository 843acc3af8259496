# SPDX-License-Identifier: MIT
"""A whole step on every backend, and the refresh interval that the original paper reports."""
from paper.style import COLUMN, panels, plain_ticks, plot, spheres_axis

NAME = "step"
CAPTION = ("A whole step (motion, plane, all pairs, counts) against the number of spheres, the original paper's "
           "box. The line is the 16\\,ms that the original paper reports for its parallel version: one tick of "
           "its clock or one refresh of its display.")


def draw(machine):
    figure, (axis,) = panels(COLUMN, 2.1)
    for name in ("cpu", "opengl", "vulkan", "cuda"):
        if machine.has(name):
            plot(axis, machine.need(table="step", backend=name), "cpu parallel" if name == "cpu" else name)
    axis.axhline(16, color="black", linewidth=0.7)
    axis.text(0.02, 17, "16 ms: one refresh at 60 Hz", transform=axis.get_yaxis_transform(), fontsize=6.5, va="bottom")
    axis.set_yscale("log")
    axis.set_ylim(top=max(axis.get_ylim()[1], 60))
    plain_ticks(axis)
    spheres_axis(axis)
    axis.set_ylabel("time of one step (ms)")
    axis.legend(loc="best")
    return figure
