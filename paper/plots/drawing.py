# SPDX-License-Identifier: MIT
"""Drawing: every method to draw n spheres, and the original paper's."""
from paper.records import named, original_paper
from paper.style import PAGE, SERIES, panels, plain_ticks, plot, spheres_in_decades

NAME, TABLE = "drawing", "draw"
CAPTION = ("Drawing: time of one frame against the number of spheres, for each method. Black: the original "
           "paper's sequential rendering as printed (GeForce GTX 590).")
MARKERS = "osD^vP*"
DASHES = ("-", "--", (0, (1, 1)), "-.", ":", (0, (5, 1)), (0, (3, 1, 1, 1)))
NAMES = {"compute": "rasteriser", "mesh_each": "mesh, one draw per sphere", "mesh": "mesh, instanced",
         "mesh_indexed": "mesh, shared vertices", "points": "points", "impostor": "impostors"}


def source(machine):
    return named(machine, machine.need(table=TABLE, work="frame"))


def draw_place(axis, rows):
    ways = list(dict.fromkeys((row.backend, row.draw) for row in rows))
    for k, (backend, way) in enumerate(ways):
        series = backend if backend != "cpu" else "cpu parallel"
        plot(axis, [row for row in rows if (row.backend, row.draw) == (backend, way)], series,
             label=f"{SERIES[series]['label'].split(',')[0]}, {NAMES[way]}", marker=MARKERS[k % len(MARKERS)],
             linestyle=DASHES[k % len(DASHES)])


def draw(machine):
    rows = machine.need(table=TABLE, work="frame")
    places = list(dict.fromkeys(row.place for row in rows))
    figure, axes = panels(PAGE, 2.6, len(places), sharey=True)
    printed = [(row[0], row[2]) for row in original_paper()["table1"] if row[2] > 0]
    for axis, place in zip(axes, places):
        axis.plot(*zip(*printed), **{**SERIES["original sequential"], "label": "original paper, sequential"})
        draw_place(axis, [row for row in rows if row.place == place])
        axis.set_yscale("log")
        plain_ticks(axis)
        spheres_in_decades(axis, [n for n, _ in printed] + [row.n for row in rows])
        axis.set_title(f"camera {place}", loc="left")
    axes[0].set_ylabel("time of one frame (ms)")
    shown = {label: handle for axis in axes for handle, label in zip(*axis.get_legend_handles_labels())}
    axes[-1].legend(shown.values(), shown.keys(), loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
