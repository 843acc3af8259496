# SPDX-License-Identifier: MIT
"""Time ratio OpenGL/CUDA of every recorded contest against the number of spheres, one panel a kind of work."""
import math

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator

from paper.numbers.contests import KINDS, contests, decided, several
from paper.style import PAGE, plt

NAME = "ratio-by-duration"
TITLES = {"all pairs": "Whole steps, all pairs", "grid": "Uniform grid", "motion": "Motion", "drawing": "Drawing", "contacts": "Contacts"}
CUDA, OPENGL, OPEN = "#c8640f", "#15396b", "#9a9a9a"
CLEAR = {"CUDA takes less time": CUDA, "OpenGL takes less time": OPENGL, "undecided": OPEN}
NAMED = 1.8  # a scene is named in its panel from this factor on
TICKS = (0.125, 0.25, 0.5, 1, 2, 4, 8)


def runs(machine):
    return ", ".join(sorted({entry.source for entry in contests(machine)}))


def source(machine):
    """The contests are of several runs."""
    return machine.short.replace(machine.id, runs(machine))


def caption(machine):
    found = contests(machine)
    cuda, opengl = decided(found)
    return (f"OpenGL's time over CUDA's for the same work, one dot for each of {len(found):,} contests of all sizes, scenes, methods and "
            f"group sizes; above 1 CUDA takes less time. Bars: 95 \\% intervals; filled: over processes ({len(several(found)):,} contests), "
            f"hollow: over the rounds of one process. A difference is stated after Holm's correction over a panel's contests: CUDA takes less "
            f"time in {len(cuda):,}, OpenGL in {len(opengl):,}. Line: whole steps. Dots of one size stand side by side.")


def color_of(entry):
    return OPEN if not entry.ratio.decided else CUDA if entry.ratio.middle > 1 else OPENGL


def places(found):
    """x of each: the contests of one size side by side, by their ratios, within a fifth of a decade at most."""
    by_n = {}
    for entry in sorted(found, key=lambda entry: entry.ratio.middle):
        by_n.setdefault(entry.n, []).append(entry)
    made = {}
    for n, own in by_n.items():
        width = min(0.1, 0.012 * len(own))
        for k, entry in enumerate(own):
            turn = (k * 0.618034) % 1 - 0.5 if len(own) > 1 else 0  # neighbours in ratio are far apart
            made[id(entry)] = n * 10**(2 * width * turn)
    return made


def draw_contests(axis, found, size):
    at = places(found)
    for entry in found:
        color, x = color_of(entry), at[id(entry)]
        axis.plot([x, x], [entry.ratio.low, entry.ratio.high], color=color, linewidth=0.6, alpha=0.45, solid_capstyle="butt")
        axis.plot(x, entry.ratio.middle, linestyle="none", marker="o", markersize=size, markeredgewidth=0.6, markeredgecolor=color,
                  markerfacecolor=color if entry.ratio.processes > 1 else "white", alpha=0.85)
    steps = [entry for entry in found if entry.table == "step"]
    axis.plot([entry.n for entry in steps], [entry.ratio.middle for entry in steps], color="black", linewidth=0.9, zorder=1.9)


def name_of(entry):
    method, _, scene = entry.what.partition(", ")
    return "whole steps" if entry.table == "step" else scene.replace("all spheres in ", "all in ") or method


def name_extremes(axis, found, size):
    """The least and the greatest ratio of a panel, where it is far from 1."""
    for sign in (-1, 1):
        entry = max(found, key=lambda each: sign * math.log(each.ratio.middle))
        if entry.work != "contacts" and sign * math.log(entry.ratio.middle) > math.log(NAMED):  # contacts have one scene
            end = entry.ratio.high if sign > 0 else entry.ratio.low
            axis.annotate(name_of(entry), (entry.n, end), xytext=(0, 3 * sign), textcoords="offset points", ha="center",
                          va="bottom" if sign > 0 else "top", color=color_of(entry), fontsize=size)


def limits(found):
    """((left, right), (bottom, top)): every dot and interval, with room for names."""
    sizes = [entry.n for entry in found]
    low, high = min(entry.ratio.low for entry in found), max(entry.ratio.high for entry in found)
    return (min(sizes) / 2.5, 2.5 * max(sizes)), (min(low / 1.5, 0.8), max(high * 1.3, 1.25))


def style_axis(axis, across, up):
    axis.axhline(1, color="black", linewidth=0.8, zorder=1.8)
    axis.set(xscale="log", yscale="log", xlim=across, ylim=up)
    axis.xaxis.set_major_locator(LogLocator(base=100, numticks=9))
    axis.yaxis.set_major_locator(FixedLocator([tick for tick in TICKS if up[0] <= tick <= up[1]]))
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    for side in (axis.xaxis, axis.yaxis):
        side.set_minor_locator(NullLocator())
    axis.grid(axis="x", visible=False)


def legend_of(found):
    dots = [Line2D([], [], linestyle="none", marker="o", markersize=4.5, color=color, label=words) for words, color in CLEAR.items()
            if any(color_of(entry) == color for entry in found)]
    hollow = Line2D([], [], linestyle="none", marker="o", markersize=4.5, color="black", markerfacecolor="white", label="one process only")
    line = Line2D([], [], color="black", linewidth=0.9, label="whole steps")
    return dots + [hollow] * any(entry.ratio.processes == 1 for entry in found) + [line] * any(entry.table == "step" for entry in found)


def draw_panels(machine, width, height, columns, size):
    """The legend takes the cell behind the last panel."""
    found = contests(machine)
    kinds = [kind for kind in KINDS if any(entry.work == kind for entry in found)]
    rows = len(kinds) // columns + 1
    figure, axes = plt.subplots(rows, columns, figsize=(width, height * rows), sharey=True, squeeze=False, layout="constrained")
    bounds = limits(found)
    for axis, kind in zip(axes.flat, kinds):
        own = [entry for entry in found if entry.work == kind]
        style_axis(axis, *bounds)
        draw_contests(axis, own, size)
        name_extremes(axis, own, plt.rcParams["xtick.labelsize"])
        axis.set_title(TITLES[kind], loc="left", fontweight="bold")
    for axis in axes.flat[len(kinds):]:
        axis.set_axis_off()
    axes.flat[len(kinds)].legend(handles=legend_of(found), loc="center left", borderaxespad=0)
    for axis in axes.flat[max(0, len(kinds) - columns):len(kinds)]:
        axis.set_xlabel("number of spheres")
    figure.supylabel("OpenGL time / CUDA time", fontsize=plt.rcParams["axes.labelsize"])
    return figure


def draw(machine):
    """For print."""
    return draw_panels(machine, PAGE, 1.7, 3, 2.2)


def draw_headline(machine):
    """For a screen as narrow as a telephone's."""
    with plt.rc_context({"font.size": 10, "axes.labelsize": 9, "axes.titlesize": 10, "xtick.labelsize": 9, "ytick.labelsize": 9,
                         "legend.fontsize": 9}):
        figure = draw_panels(machine, 4.4, 1.7, 2, 2.4)
        figure.supxlabel(f"{machine.backend('cuda')['device']}, driver {machine.driver}", x=0.99, ha="right", fontsize=8, color="#555555")
        return figure
