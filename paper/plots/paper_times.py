# SPDX-License-Identifier: MIT
"""The original paper's figure 5: its printed times and ours."""
from paper.records import Missing, original_paper
from paper.style import PAGE, SERIES, panels, plain_ticks, plot, spheres_axis

NAME = "paper-times"
CAPTION = ("The original paper's figure 5. (a) Finding the colliding pairs; (b) motion and plane. Black: as "
           "printed there (GeForce GTX 590; its zeros cannot be shown on this axis). Ours are exact and count the contacts of "
           "each sphere.")


def printed(axis, column, series):
    rows = [(row[0], row[column]) for row in original_paper()["table1"] if row[column] > 0]
    axis.plot(*zip(*rows), **SERIES[series])


def draw(machine):
    figure, (pairs, plane) = panels(PAGE, 2.3, 2)
    printed(pairs, 6, "original parallel")
    printed(pairs, 5, "original sequential")
    printed(plane, 4, "original sequential")
    for method in ("sequential", "parallel"):
        plot(pairs, machine.need(table="table1", backend="cpu", method=method), f"cpu {method}")
    plot(plane, machine.need(table="table1", backend="cpu", work="move"), "cpu parallel")
    devices = [name for name in ("glsl", "cuda") if machine.has(name)]
    if not devices:
        raise Missing(f"{machine.name} was run without GLSL and CUDA")
    for name in devices:
        label = SERIES[name]["label"]
        tiled = machine.need(table="table1", backend=name, method="collide_tiled")
        plot(pairs, tiled, name, label=f"{label}, original paper's tile", alpha=0.55)
        plot(pairs, machine.need(table="table1", backend=name, method="collide_triangle"), name,
             label=f"{label}, upper triangle", markerfacecolor=SERIES[name]["color"])
        plot(plane, machine.need(table="table1", backend=name, work="move"), name, label=f"{label}, motion")
    for axis, title in ((pairs, "(a) colliding pairs"), (plane, "(b) motion and plane")):
        axis.set_yscale("log")
        spheres_axis(axis)
        plain_ticks(axis)
        axis.set_title(title, loc="left")
        axis.set_ylabel("time of one step (ms)")
    shown = {label: handle for axis in (pairs, plane) for handle, label in zip(*axis.get_legend_handles_labels())}
    plane.legend(shown.values(), shown.keys(), loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=2.6)
    return figure
