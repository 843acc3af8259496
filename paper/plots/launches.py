# SPDX-License-Identifier: MIT
"""The time of a step on every path by which its launches reach the GPU, against the number of spheres."""
from paper.numbers.derived import needed_devices
from paper.style import PAGE, panels, plain_ticks, plot, spheres_axis
from paper.text import APIS

NAME = "launch-paths"
TABLE = "launches"
CAPTION = ("The same kernels, launched in other ways: time of a step (slope of three batches) against the number of "
           "spheres. (a) A move and all pairs, two launches; the persistent kernel has a loop over pairs of its own. (b) The "
           "grid's search in random order, three launches. Waited: the host waits for each launch. Graphs: of one step each, or of up "
           "to 64 steps. Programmatic: kernels get ready while the one before runs; on the stream and in graphs of many steps, as in "
           "OpenGL without a barrier, the first overlaps the step before.")
WORKS = {"all_pairs": "(a) a move and all pairs", "grid": "(b) the grid"}
LINES = {"waited": ("waited", ":", "v"), "batched": ("batched", "-", "o"), "overlapping": ("without a barrier", "--", "^"),
         "stream": ("stream", "-", "s"), "stream_programmatic": ("stream, programmatic", "--", "D"), "graph": ("graph", "-.", "o"),
         "graph_programmatic": ("graph, programmatic", (0, (5, 1, 1, 1, 1, 1)), "P"),
         "graph_steps": ("graph of steps", "-", "v"), "graph_steps_programmatic": ("graph of steps, programmatic", "--", "X"),
         "persistent": ("persistent kernel", (0, (1, 1)), "*")}


def draw_path(axis, rows, backend, path):
    words, line, marker = LINES[path]
    plot(axis, rows, backend, scale=1e3, label=f"{APIS[backend]}, {words}", linestyle=line, marker=marker, markersize=3)


def draw(machine):
    devices = needed_devices(machine, table=TABLE)
    figure, axes = panels(PAGE, 2.6, len(WORKS), sharey=True)
    for axis, (work, title) in zip(axes, WORKS.items()):
        for backend in devices:
            for path in LINES:
                rows = machine.select(table=TABLE, work=work, backend=backend, path=path)
                if rows:
                    draw_path(axis, rows, backend, path)
        spheres_axis(axis)
        axis.set_yscale("log")
        plain_ticks(axis)
        axis.set_title(title, loc="left")
        axis.legend(fontsize=6, loc="upper left", ncols=2)
    axes[0].set_ylim(top=3000)  # the legends' room
    axes[0].set_ylabel("time of a step (µs)")
    return figure
