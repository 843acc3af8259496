# SPDX-License-Identifier: MIT
"""The time of a step through OpenGL, Vulkan and CUDA, against the number of spheres."""
from matplotlib.ticker import NullLocator

from paper.numbers.apis import WAYS, fastest, rows, sizes
from paper.style import PAGE, panels, plt, spheres_axis

NAME = "three-apis"
CAPTION = ("Time of a step (slope of three batches) against the number of spheres, each API on the fastest of its paths on which no "
           "launch is waited for. OpenGL and Vulkan run the same GLSL. The grid's search may overlap the step before; in a CUDA graph of "
           "one step it cannot.")
WORKS = {"all_pairs": "A move and all pairs", "grid": "The grid, random order"}
COLOURS = {"opengl": "#15396b", "vulkan": "#b5322b", "cuda": "#e0812b"}
MOST = 16384  # spheres: of more, all ways take about as long
TICKS = (3, 5, 10, 20, 50)
LINES = dict(zip(WAYS, (("-", "o"), ("-", "^"), (":", "s"), ("--", "s"), ("-", "s"))))


def draw_work(axis, machine, work):
    found = rows(machine, work)
    for way, (backend, _) in WAYS.items():
        line, marker = LINES[way]
        points = [(n, 1e3 * row.median) for n in sizes(found, MOST) if (row := fastest(found, way, n))]
        axis.plot(*zip(*points), color=COLOURS[backend], linestyle=line, marker=marker, markersize=3.5, label=way,
                  markerfacecolor="white" if backend == "cuda" else COLOURS[backend])
    spheres_axis(axis)
    axis.set_yscale("log")
    axis.set_yticks(TICKS, map(str, TICKS))
    axis.yaxis.set_minor_locator(NullLocator())
    axis.set_title(WORKS[work], loc="left", fontweight="bold")


def draw(machine):
    for backend in COLOURS:
        machine.need(table="launches", backend=backend)
    figure, axes = panels(PAGE, 2.6, len(WORKS))
    for axis, work in zip(axes, WORKS):
        draw_work(axis, machine, work)
    axes[0].set_ylabel("time of a step (µs)")
    axes[0].legend(loc="upper left")
    return figure


def draw_headline(machine):
    """For a screen as narrow as a telephone's."""
    with plt.rc_context({"font.size": 10, "axes.labelsize": 9, "axes.titlesize": 10, "xtick.labelsize": 9, "ytick.labelsize": 9,
                         "legend.fontsize": 8.5}):
        figure = draw(machine)
        figure.set_size_inches(6.4, 3.1)
        return figure
