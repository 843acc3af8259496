# SPDX-License-Identifier: MIT
"""Error of the motion against its run time: what each method and precision buys."""
from matplotlib.lines import Line2D

from records import Missing
from style import PAGE, panels

NAME, TABLE = "work-precision", "precision"
CAPTION = ("Rms error of the position against run time, a point a time step; every method (line) in every "
           "precision (marker) it has. Below and to the left is better.")
MARKERS = {"float32": "o", "compensated": "s", "float64": "^"}
LINES = ("-", "--", ":", "-.")


def kind(row):
    """Anchored positions are evaluated only when they are asked for: with that, it is a method of its own."""
    return row.method if row.work == "move" else f"{row.method} {row.work.replace('move and', '+')}"


def look(methods, method):
    place = methods.index(method)
    return {"color": f"C{place}", "linestyle": LINES[place % len(LINES)]}


def draw_device(axis, rows, methods):
    for method in methods:
        for precision, marker in MARKERS.items():
            line = sorted((row for row in rows if (kind(row), row.precision) == (method, precision)),
                          key=lambda row: row.dt)
            nanoseconds = [1e6 * row.median / row.n / row.dt for row in line]
            axis.plot(nanoseconds, [row.error_m for row in line], marker=marker, **look(methods, method))
    axis.set(xscale="log", yscale="log", xlabel="run time of a simulated second (ns a sphere)")


def draw(machine):
    rows = machine.need(table=TABLE)
    devices = [name for name in ("cpu", "glsl", "cuda") if any(row.backend == name for row in rows)]
    unknown = sorted({row.precision for row in rows} - MARKERS.keys())
    if unknown:
        raise Missing(f"{machine.name} has precisions that this figure does not know: {', '.join(unknown)}")
    figure, axes = panels(PAGE, 2.6, len(devices), sharey=True)
    methods = list(dict.fromkeys(kind(row) for row in rows))
    for axis, device in zip(axes, devices):
        draw_device(axis, [row for row in rows if row.backend == device], methods)
        axis.set_title(device.upper(), loc="left")
    axes[0].set_ylabel(f"rms error after {rows[0].simulated_s:g} s (m)")
    keys = [Line2D([], [], label=method, **look(methods, method)) for method in methods]
    keys += [Line2D([], [], label=name, color="black", marker=marker, linestyle="") for name, marker in MARKERS.items()]
    axes[-1].legend(handles=keys, loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
