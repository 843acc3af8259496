# SPDX-License-Identifier: MIT
"""Roofline: the floor from the device's peak rates over each time."""
from paper.numbers.derived import GRID_BYTES, grid_share_of_floor, needed_devices
from paper.records import Missing
from paper.style import PAGE, SERIES, panels, spheres_in_decades

NAME, TABLE = "floor", "grid"
CAPTION = ("Share of the floor: the least time by the peak rates, over the measured time. "
           "(a) The grid, whose floor is its minimum memory traffic (per sphere {warm} bytes in cell order, {cold} in "
           "random order) over the highest copy rate recorded of data that fits no cache, the base of every share; small "
           "sizes fit the caches, which copy faster. (b) All pairs by the upper triangle, whose floor is four instructions per pair over the issue "
           "rate. Packing fraction 0.3.")
LINES = {"warm": "-", "cold": "--"}


def with_floor(machine, **wanted):
    rows = machine.select(table=TABLE, scene="uniform", packing_fraction=0.3, **wanted)
    return [row for row in rows if "share_of_floor" in row.parameters]


def bytes_per_sphere(row):
    """As counted by the run: the floor's time and the copy rate."""
    return round(1e-3 * row.floor_ms * row.peak_per_second / row.n)


def caption(machine):
    for order, wanted in GRID_BYTES.items():
        found = {bytes_per_sphere(row) for row in with_floor(machine, method="collide_grid", order=order)}
        if wanted not in found:
            raise Missing(f"{machine.name}: no record of the grid counts {wanted} bytes a sphere, {order}, but {found}")
    return CAPTION.format(**GRID_BYTES)


def draw(machine):
    devices = needed_devices(machine, table=TABLE)
    if not with_floor(machine):
        raise Missing(f"{machine.name} has no record of the table {TABLE} with its floor")
    figure, axes = panels(PAGE, 2.2, 2, sharey=True)
    for name in devices:
        for order, line in LINES.items():
            rows = with_floor(machine, backend=name, method="collide_grid", order=order)
            axes[0].plot([r.n for r in rows], [grid_share_of_floor(machine, r) for r in rows],
                         **{**SERIES[name], "linestyle": line, "label": f"{SERIES[name]['label']}, {order}"})
        rows = with_floor(machine, backend=name, method="collide_triangle")
        axes[1].plot([r.n for r in rows], [100 * r.share_of_floor for r in rows], **SERIES[name])
    for axis, title in zip(axes, ("(a) grid", "(b) all pairs")):
        spheres_in_decades(axis, [row.n for row in with_floor(machine)])
        axis.set_ylim(0, 100)
        axis.set_title(title, loc="left")
        axis.legend()
    axes[0].set_ylabel("share of the floor (%)")
    return figure
