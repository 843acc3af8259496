# SPDX-License-Identifier: MIT
"""The grid against all pairs: time a sphere against the number of spheres."""
from records import Missing
from style import PAGE, SERIES, panels, plain_ticks, plot, spheres_axis

NAME = TABLE = "grid"
CAPTION = ("The uniform grid against all pairs, packing fraction 0.3: time of one collision step divided by the "
           "number of spheres. A line that rises with slope 1 is quadratic in $n$, a level one linear.")
LINES = {"warm": "-", "cold": "--", None: "-"}


def per_sphere(axis, rows, series, **look):
    """Nanoseconds a sphere."""
    for record in rows:
        plot(axis, [record], series, scale=1e6 / record.n, **{**look, "label": None, "linestyle": ""})
    axis.plot([r.n for r in rows], [1e6 * r.median / r.n for r in rows], **{**SERIES[series], **look})


def orders(rows):
    """The input orders that were timed: cold is random, warm that of the cells; None where the record does not say."""
    return list(dict.fromkeys(record.parameters.get("order") for record in rows))


def draw(machine):
    grid = machine.need(table=TABLE, method="collide_grid", scene="uniform")
    figure, (axis,) = panels(PAGE, 2.4)
    for name in ("glsl", "cuda"):
        if not machine.has(name):
            continue
        label = SERIES[name]["label"]
        for order in orders(grid):
            rows = [r for r in grid if r.backend == name and r.parameters.get("order") == order]
            if len({r.n for r in rows}) != len(rows):
                raise Missing(f"{machine.name} has several records of the grid for one number of spheres")
            per_sphere(axis, rows, name, linestyle=LINES[order],
                       label=f"{label}, grid" + (f", {order} input" if order else ""))
        pairs = machine.need(table="scale", scene="uniform", backend=name)
        per_sphere(axis, pairs, name, linestyle=":", alpha=0.6, label=f"{label}, all pairs")
    axis.set_yscale("log")
    plain_ticks(axis)
    spheres_axis(axis)
    axis.set_ylabel("time of one step per sphere (ns)")
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
