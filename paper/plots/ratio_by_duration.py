# SPDX-License-Identifier: MIT
"""Time ratio GLSL/CUDA of every recorded contest against the duration of CUDA's step."""
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from paper.numbers.contests import bins, contests, duration, rule
from paper.style import PAGE, panels, time_text

NAME = "ratio-by-duration"
LOOKS = {"all pairs": ("o", "#15396b"), "grid": ("s", "#e0812b"), "motion": ("^", "#5b8c5a"), "drawing": ("D", "#8a3b6b")}
LEAST, MOST = 0.58, 2.4  # contests beyond stand on the edge
TICKS = (0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.7, 2, 2.4)


def runs(machine):
    return ", ".join(sorted({entry.source for entry in contests(machine)}))


def source(machine):
    """The contests are of several runs."""
    return machine.short.replace(machine.id, runs(machine))


def caption(machine):
    found = contests(machine)
    count = sum(not LEAST <= entry.ratio <= MOST for entry in found)
    beyond = f", {count} of them beyond the axis and drawn on its edge" if count else ""
    return (f"GLSL's time over CUDA's for the same work against the time of CUDA's step, for contests of all sizes, "
            f"scenes, methods and group sizes{beyond}. Above 1 CUDA is faster. Black, and the figures on top: the median of the "
            f"contests between two ticks. {rule(machine)}")


def draw_medians(axis, made, left, right):
    for each in made:
        low, high = max(each.low, left), min(each.high, right)
        axis.plot([low, high], [each.median, each.median], color="black", linewidth=1.6, solid_capstyle="butt", zorder=4)
        axis.text((low * high)**0.5, 1.0, f"{each.median:.2f}", transform=axis.get_xaxis_transform(), ha="center", va="bottom",
                  fontsize=7.5, fontweight="bold")


def draw(machine):
    found = contests(machine)
    figure, (axis,) = panels(PAGE, 2.7)
    for work, (marker, color) in LOOKS.items():
        chosen = [entry for entry in found if entry.work == work]
        if chosen:  # nothing drawn without clipping takes room, too
            axis.plot([entry.cuda_us for entry in chosen], [min(max(entry.ratio, LEAST), MOST) for entry in chosen],
                      linestyle="none", marker=marker, markersize=3.2, markeredgewidth=0, color=color, clip_on=False,
                      alpha=0.75)
        axis.plot([], [], linestyle="none", marker=marker, color=color, label=work)
    left, right = 0.9 * found[0].cuda_us, 1.1 * found[-1].cuda_us
    made = bins(found)
    draw_medians(axis, made, left, right)
    axis.axhline(1, color="black", linewidth=0.7)
    axis.set(xscale="log", yscale="log", xlim=(left, right), ylim=(LEAST, MOST), xlabel="time of a step in CUDA", ylabel="GLSL time / CUDA time")
    edges = [each.low for each in made if each.low] + [10**k for k in range(4, 7) if 10**k < right]
    axis.xaxis.set_major_locator(FixedLocator(edges))
    axis.xaxis.set_minor_locator(NullLocator())
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: duration(value)))
    axis.yaxis.set_major_locator(FixedLocator(TICKS))
    axis.yaxis.set_minor_locator(NullLocator())
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    for name, offset, side in (("CUDA", 2, "bottom"), ("GLSL", -3, "top")):
        axis.annotate(f" {name} faster", (0.0, 1.0), xycoords=axis.get_yaxis_transform(), xytext=(0, offset),
                      textcoords="offset points", va=side, fontsize=7)
    axis.legend(loc="lower right", ncols=2)
    return figure
