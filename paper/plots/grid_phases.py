# SPDX-License-Identifier: MIT
"""The grid's time by kernel, from a size within the caches to sizes beyond."""
from paper.numbers.derived import needed_devices
from paper.plots.phases import draw_bars
from paper.records import Missing, named
from paper.style import PAGE, SERIES, panels

NAME, TABLE = "grid-phases", "grid"
CAPTION = ("The grid's time by kernel, from device timers, per sphere, packing fraction 0.3. "
           "Warm: the spheres are in cell order; cold: in random order. Black mark: the host's time of "
           "back-to-back steps.")
SIZES = (1_000_000, 10_000_000, 100_000_000)


def timed(machine, **wanted):
    rows = machine.select(table=TABLE, scene="uniform", packing_fraction=0.3, method="collide_grid", **wanted)
    return [row for row in rows if row.parameters.get("device_stages_ms")]


def drawn(machine):
    return [row for n in SIZES for order in ("warm", "cold") for name in needed_devices(machine, table=TABLE)
            for row in timed(machine, backend=name, order=order, n=n)]


def source(machine):
    return named(machine, drawn(machine))


def draw(machine):
    rows = drawn(machine)
    if not rows:
        raise Missing(f"{machine.name} has no device times of the grid at {SIZES[0]:,} spheres or more")
    figure, (axis,) = panels(PAGE, 0.7 + 0.16 * len(rows))
    names = [f"{SERIES[row.backend]['label']}, {row.order}, n = {row.n:,}" for row in rows]
    draw_bars(axis, rows, names, lambda record: 1e6 / record.n)
    axis.set_xlabel("time per sphere (ns)")
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=1.4)
    return figure
