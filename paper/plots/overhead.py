# SPDX-License-Identifier: MIT
"""The cost of a dispatch or launch of an empty kernel."""
from paper.numbers.derived import devices_of
from paper.style import COLUMN, panels, plain_ticks, plot

NAME = "overhead"
CAPTION = ("An empty kernel of one group: time per dispatch or launch against their number before the host "
           "waits. CUDA launches without a graph. The first point is a round trip, the last the rate.")


def draw(machine):
    devices = devices_of(machine)
    figure, (axis,) = panels(COLUMN, 1.7)
    for name in devices:
        for record in machine.need(table="overhead", backend=name):
            first = record is machine.need(table="overhead", backend=name)[0]
            plot(axis, [record], name, x=lambda r: r.launches_per_step, scale=1e3 / record.launches_per_step,
                 **({} if first else {"label": None}))
        rows = machine.need(table="overhead", backend=name)
        axis.plot([r.launches_per_step for r in rows], [1e3 * r.median / r.launches_per_step for r in rows],
                  color="#aaaaaa", linewidth=0.6, zorder=0)
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.tick_params(axis="y", which="minor", labelsize=7)
    plain_ticks(axis)
    axis.yaxis.set_minor_formatter(lambda value, _: f"{value:g}" if f"{value:e}"[0] in "25" else "")
    axis.xaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    axis.set_xlabel("launches between two waits")
    axis.set_ylabel("time per launch (µs)")
    axis.legend()
    return figure
