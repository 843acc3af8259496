# SPDX-License-Identifier: MIT
"""Work-precision diagram of contacts, one panel per law: both APIs, three ways to add up impulses."""
from matplotlib.lines import Line2D

from paper.numbers.pareto import devices
from paper.records import named
from paper.style import PAGE, SERIES, panels

NAME = "contact-precision"
CAPTION = ("Contacts: rms position error of a gas against the run time, one point per time step, from 10 steps a "
           "contact on. Impulses are added up as integers, in float32 in a fixed order, or in float32 by atomics, "
           "whose bits differ from run to run.")
LOOKS = {"integers": {"marker": "o", "linestyle": "-"},
         "in_order": {"marker": "s", "linestyle": "--", "markerfacecolor": "white"},
         "atomics": {"marker": "x", "linestyle": ":"}}
LABELS = {"integers": "integers", "in_order": "float32, in order", "atomics": "float32, atomics"}


def study(machine):
    return machine.need(table="contact_runs")


def source(machine):
    return named(machine, study(machine))


def law_of(row):
    return row.law if row.restitution == 1 else f"{row.law}, restitution {row.restitution:.3g}"


def colour(backend):
    return SERIES[backend if backend != "cpu" else "cpu parallel"]["color"]


def draw_law(axis, rows):
    for backend in devices(rows):
        for sums, look in LOOKS.items():
            line = sorted((row for row in rows if (row.backend, row.sums) == (backend, sums)),
                          key=lambda row: row.steps_a_contact)
            axis.plot([row.median * row.steps for row in line], [row.position for row in line],
                      color=colour(backend), **look)
    axis.set(xscale="log", yscale="log")


def keys(rows):
    names = {"cpu": "CPU", **{name: SERIES[name]["label"] for name in ("opengl", "cuda")}}
    return [Line2D([], [], label=names[backend], color=colour(backend), linewidth=2) for backend in devices(rows)] + [
        Line2D([], [], label=LABELS[sums], color="black", **look) for sums, look in LOOKS.items()]


def draw(machine):
    rows = study(machine)
    laws = list(dict.fromkeys(law_of(row) for row in rows))
    figure, axes = panels(PAGE, 2.4, len(laws), sharey=True)
    for axis, law in zip(axes, laws):
        draw_law(axis, [row for row in rows if law_of(row) == law])
        axis.set_title(law, loc="left")
    axes[len(axes) // 2].set_xlabel("run time (ms)")
    axes[0].set_ylabel("rms error (radii)")
    axes[-1].legend(handles=keys(rows), loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
