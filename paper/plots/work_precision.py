# SPDX-License-Identifier: MIT
"""Work-precision diagram of the motion methods, one panel per backend."""
from matplotlib.lines import Line2D

from paper.numbers.pareto import devices, draw_front, kind, mark_paper, same_time, seconds, study
from paper.records import Missing, named
from paper.style import PAGE, panels
from paper.text import APIS

NAME = "work-precision"
CAPTION = ("Work-precision diagram: rms position error against run time, one point per time step; every method (line) in "
           "each of its precisions (marker). Below and to the left is better; grey line: Pareto "
           "front. Star: the original paper's method at a step of 1/64 s.")
MARKERS = {"float32": "o", "compensated": "s", "float64": "^"}
LINES = ("-", "--", ":", "-.")
FRONT = {"color": "#bbbbbb", "linewidth": 4, "solid_joinstyle": "round", "zorder": 0}


def source(machine):
    return named(machine, study(machine))


def look(methods, method):
    k = methods.index(method)
    broad = {"linewidth": 2.4, "markersize": 5.5, "zorder": 1.5} if method == "paper" else {}  # paper-clamp lies on it
    return {"color": f"C{k}", "linestyle": LINES[k % len(LINES)], **broad}


def draw_device(axis, rows, methods):
    draw_front(axis, rows, **FRONT)
    for method in methods:
        for precision, marker in MARKERS.items():
            line = sorted((row for row in rows if (kind(row), row.precision) == (method, precision)),
                          key=lambda row: row.dt)
            axis.plot([seconds(row) for row in line], [row.error_m for row in line], marker=marker,
                      **look(methods, method))
    mark_paper(axis, rows)
    axis.set(xscale="log", yscale="log")


def keys(methods):
    lines = [Line2D([], [], label=method, **look(methods, method)) for method in methods]
    lines += [Line2D([], [], label=name, color="black", marker=marker, linestyle="")
              for name, marker in MARKERS.items()]
    lines.append(Line2D([], [], label="Pareto front", **{**FRONT, "linewidth": 3}))
    return lines + [Line2D([], [], label="original paper", marker="*", markersize=8, color="black",
                           markerfacecolor="#f2d024", linestyle="")]


def draw(machine):
    rows = study(machine)
    unknown = sorted({row.precision for row in rows} - MARKERS.keys())
    if unknown:
        raise Missing(f"{machine.name} has precisions that this figure does not know: {', '.join(unknown)}")
    time, names = same_time(rows), devices(rows)
    figure, axes = panels(PAGE, 2.6, len(names), sharey=True)
    methods = list(dict.fromkeys(kind(row) for row in rows))
    for axis, device in zip(axes, names):
        draw_device(axis, [row for row in rows if row.backend == device], methods)
        axis.set_title(APIS[device], loc="left")
    axes[len(axes) // 2].set_xlabel("run time of a simulated second (ns per sphere)")
    axes[0].set_ylabel(f"rms error after {time:g} s (m)")
    axes[-1].legend(handles=keys(methods), loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
