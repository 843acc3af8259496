# SPDX-License-Identifier: MIT
"""Drawing: every way to put n spheres on the screen, beside the original paper's."""
from records import original_paper
from style import PAGE, SERIES, panels, plain_ticks, plot, spheres_axis

NAME = "drawing"
CAPTION = ("Drawing: time of one picture against the number of spheres, for each way to draw. Black: the original "
           "paper's sequential rendering as printed (GeForce GTX 590).")
MARKERS = "osD^vP*"


def draw(machine):
    rows = machine.need(table="draw")
    figure, (axis,) = panels(PAGE, 2.6)
    printed = [(row[0], row[2]) for row in original_paper()["table1"] if row[2] > 0]
    axis.plot(*zip(*printed), **{**SERIES["original sequential"], "label": "original paper, sequential"})
    ways = list(dict.fromkeys((row.backend, row.draw) for row in rows))
    for place, (backend, way) in enumerate(ways):
        look = SERIES[backend if backend != "cpu" else "cpu parallel"]
        plot(axis, [row for row in rows if (row.backend, row.draw) == (backend, way)],
             backend if backend != "cpu" else "cpu parallel", label=f"{look['label'].split(',')[0]}, {way}",
             marker=MARKERS[place % len(MARKERS)])
    axis.set_yscale("log")
    plain_ticks(axis)
    spheres_axis(axis)
    axis.set_ylabel("time of one picture (ms)")
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
