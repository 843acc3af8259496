# SPDX-License-Identifier: MIT
"""Error of the motion against its run time: what each method and precision buys."""
from records import Missing
from style import PAGE, panels

NAME = "work-precision"
CAPTION = ("Rms error of the position against run time, a point a time step; every method with every precision it "
           "has. Below and to the left is better.")
MARKERS = {"float32": "o", "compensated": "s", "float64": "^"}
LINES = ("-", "--", ":", "-.")


def draw(machine):
    rows = machine.need(table="precision")
    devices = [name for name in ("cpu", "glsl", "cuda") if any(row.backend == name for row in rows)]
    unknown = sorted({row.precision for row in rows} - MARKERS.keys())
    if unknown:
        raise Missing(f"{machine.name} has precisions that this figure does not know: {', '.join(unknown)}")
    figure, axes = panels(PAGE, 2.8, len(devices), sharey=True)
    methods = list(dict.fromkeys(row.method for row in rows))
    for axis, device in zip(axes, devices):
        for method in methods:
            for precision, marker in MARKERS.items():
                line = sorted((row for row in rows if (row.backend, row.method, row.precision) ==
                               (device, method, precision)), key=lambda row: row.dt_s)
                axis.plot([row.median / row.dt_s for row in line], [row.error_m for row in line], marker=marker,
                          linestyle=LINES[methods.index(method) % len(LINES)], color=f"C{methods.index(method)}",
                          label=f"{method}, {precision}" if line else None)
        axis.set(xscale="log", yscale="log", xlabel="run time of a simulated second (ms)")
        axis.set_title(device.upper(), loc="left")
    axes[0].set_ylabel("rms error after 10 s (m)")
    axes[-1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
