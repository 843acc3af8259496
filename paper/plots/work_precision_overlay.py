# SPDX-License-Identifier: MIT
"""The backends' work-precision diagrams overlaid, with their Pareto fronts."""
from paper.numbers.pareto import devices, draw_front, mark_paper, same_time, seconds, study
from paper.records import Missing, named
from paper.style import COLUMN, SERIES, panels

NAME = "work-precision-overlay"
CAPTION = ("Work-precision diagram of all backends: one point per method, precision and time step, and "
           "the Pareto front of each backend. Stars: the original paper's method at a "
           "step of 1/64 s.")


def source(machine):
    return named(machine, study(machine))


def look(device):
    return SERIES[device if device != "cpu" else "cpu parallel"]


def draw(machine):
    rows = study(machine)
    names = devices(rows)
    if len(names) < 2:
        raise Missing(f"{machine.name} has one backend's records of the table precision; an overlay needs two")
    figure, (axis,) = panels(COLUMN, 2.6)
    for name in names:
        own = [row for row in rows if row.backend == name]
        axis.plot([seconds(row) for row in own], [row.error_m for row in own], alpha=0.35,
                  **{**look(name), "label": None, "linestyle": ""})
        draw_front(axis, own, **look(name))
        mark_paper(axis, own)
    axis.set(xscale="log", yscale="log", xlabel="run time of a simulated second (ns per sphere)",
             ylabel=f"rms error after {same_time(rows):g} s (m)")
    axis.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3)
    return figure
