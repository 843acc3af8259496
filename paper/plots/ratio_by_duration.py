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
TICKS = (0.25, 0.35, 0.5, 0.7, 1, 1.4, 2, 2.8, 4)


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
            f"time in {len(cuda):,}, OpenGL in {len(opengl):,}. Line: whole steps. Dots of one size stand beside each other.")


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


def name_extremes(axis, found):
    """The least and the greatest ratio of a panel, where it is far from 1."""
    for sign in (-1, 1):
        entry = max(found, key=lambda each: sign * math.log(each.ratio.middle))
        if sign * math.log(entry.ratio.middle) > math.log(NAMED):
            end = entry.ratio.high if sign > 0 else entry.ratio.low
            method, _, scene = entry.what.partition(", ")
            axis.annotate(f"{scene.removeprefix('all spheres in ') or 'whole step' if entry.table == 'step' else scene or method}",
                          (entry.n, end), xytext=(0, 3 * sign), textcoords="offset points", ha="center",
                          va="bottom" if sign > 0 else "top", color=color_of(entry), fontsize=7)


def limits(found):
    """Every dot and interval, with room for names, and 1 in the middle third."""
    low, high = min(entry.ratio.low for entry in found), max(entry.ratio.high for entry in found)
    return min(low / 1.25, 0.8), max(high * 1.25, 1.25)


def style_axis(axis, found, bounds):
    axis.axhline(1, color="black", linewidth=0.8, zorder=1.8)
    axis.set(xscale="log", yscale="log", ylim=bounds)
    low, high = min(entry.n for entry in found), max(entry.n for entry in found)
    middle = math.sqrt(low * high)
    half = max(math.sqrt(high / low) * 2, 12)
    axis.set_xlim(middle / half, middle * half)
    axis.xaxis.set_major_locator(LogLocator(base=100 if high > 1e3 * low else 10, numticks=9))
    axis.xaxis.set_minor_locator(NullLocator())
    axis.yaxis.set_major_locator(FixedLocator([tick for tick in TICKS if bounds[0] <= tick <= bounds[1]]))
    axis.yaxis.set_minor_locator(NullLocator())
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.grid(axis="x", visible=False)


def legend_of(found):
    dots = [Line2D([], [], linestyle="none", marker="o", markersize=4.5, color=color, label=words) for words, color in CLEAR.items()
            if any(color_of(entry) == color for entry in found)]
    hollow = Line2D([], [], linestyle="none", marker="o", markersize=4.5, color="black", markerfacecolor="white", label="one process only")
    line = Line2D([], [], color="black", linewidth=0.9, label="whole steps")
    return dots + [hollow] * any(entry.ratio.processes == 1 for entry in found) + [line] * any(entry.table == "step" for entry in found)


def draw_panels(machine, width, height, columns, size):
    """The legend takes the last cell of the grid of panels, or a row below them."""
    found = contests(machine)
    kinds = [kind for kind in KINDS if any(entry.work == kind for entry in found)]
    rows = -(-len(kinds) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(width, height * rows), sharey=True, squeeze=False, layout="constrained")
    bounds = limits(found)
    for axis, kind in zip(axes.flat, kinds):
        own = [entry for entry in found if entry.work == kind]
        style_axis(axis, own, bounds)
        draw_contests(axis, own, size)
        name_extremes(axis, own)
        axis.set_title(TITLES[kind], loc="left", fontweight="bold")
    for axis in axes.flat[len(kinds):]:
        axis.set_axis_off()
    for axis in axes[:, 0]:
        axis.set_ylabel("OpenGL time / CUDA time")
    return figure, axes, kinds, found


def draw(machine):
    """For print: all panels side by side."""
    figure, axes, kinds, found = draw_panels(machine, PAGE, 2.3, len(KINDS), 2.2)
    figure.supxlabel("number of spheres", fontsize=8)
    figure.legend(handles=legend_of(found), loc="outside upper center", ncols=5)
    return figure


def draw_headline(machine):
    """For a screen as narrow as a telephone's."""
    with plt.rc_context({"font.size": 10, "axes.labelsize": 9, "axes.titlesize": 10, "xtick.labelsize": 9, "ytick.labelsize": 9,
                         "legend.fontsize": 9}):
        figure, axes, kinds, found = draw_panels(machine, 4.4, 1.75, 2, 2.4)
        spare = list(axes.flat[len(kinds):])
        figure.supxlabel("number of spheres", fontsize=9)
        place = {"loc": "center left"} if spare else {"loc": "outside lower center", "ncols": 2}
        (spare[0] if spare else figure).legend(handles=legend_of(found), **place)
    return figure
