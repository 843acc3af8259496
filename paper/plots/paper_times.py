# SPDX-License-Identifier: MIT
"""The original paper's figure 5: its printed times and ours."""
from paper.numbers.derived import devices_of
from paper.records import Missing, original_paper
from paper.style import PAGE, SERIES, panels, plain_ticks, plot, spheres_axis

NAME = "paper-times"
CAPTION = ("The original paper's figure 5. (a) Finding the colliding pairs; (b) drawing an image of 1280 by 720 pixels. "
           "Black: as printed there (GeForce GTX 590; its zeros cannot be shown on this axis). Ours are exact and count the "
           "contacts of each sphere.")
DRAWN = {"sequential mesh_each": ("cpu sequential", {"label": "CPU's spheres, one draw each"}),
         "sequential quadric": ("cpu sequential", {"label": "the same, glutSolidSphere's", "marker": "v",
                                                   "linestyle": "-."}),
         "opengl mesh": ("opengl", {"label": "OpenGL, one instanced draw"}),
         "cuda mesh": ("cuda", {"label": "CUDA, one instanced draw"})}


def printed(axis, column, series):
    rows = [(row[0], row[column]) for row in original_paper()["table1"] if row[column] > 0]
    axis.plot(*zip(*rows), **SERIES[series])


def draw(machine):
    figure, (pairs, drawing) = panels(PAGE, 2.3, 2)
    printed(pairs, 6, "original parallel")
    printed(pairs, 5, "original sequential")
    printed(drawing, 2, "original sequential")
    for method in ("sequential", "parallel"):
        plot(pairs, machine.need(table="table1", backend="cpu", method=method), f"cpu {method}")
    devices = devices_of(machine)
    for name in devices:
        label = SERIES[name]["label"]
        tiled = machine.need(table="table1", backend=name, method="collide_tiled")
        plot(pairs, tiled, name, label=f"{label}, original paper's tile", alpha=0.55)
        plot(pairs, machine.need(table="table1", backend=name, method="collide_triangle"), name,
             label=f"{label}, upper triangle", markerfacecolor=SERIES[name]["color"])
    for drawn, (series, looks) in DRAWN.items():
        rows = machine.select(table="frame_rates", work="draw", label=drawn)
        if rows:
            plot(drawing, rows, series, **looks)
        elif drawn == "opengl mesh":
            raise Missing(f"{machine.name} has no record of drawing (compare --tables frame_rates)")
    for axis, title in ((pairs, "(a) colliding pairs"), (drawing, "(b) drawing")):
        axis.set_yscale("log")
        spheres_axis(axis)
        plain_ticks(axis)
        axis.set_title(title, loc="left")
        axis.set_ylabel("time of one step (ms)" if axis is pairs else "time of one image (ms)")
    shown = {label: handle for axis in (pairs, drawing) for handle, label in zip(*axis.get_legend_handles_labels())}
    drawing.legend(shown.values(), shown.keys(), loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
