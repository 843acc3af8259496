# SPDX-License-Identifier: MIT
"""The grid and all pairs up to the largest size that fits: time per sphere against the number of spheres."""
from paper.numbers.derived import crossover, needed_devices, slope
from paper.records import Missing
from paper.style import PAGE, SERIES, panels, plain_ticks, plot, spheres_in_decades

NAME = TABLE = "grid"
CAPTION = ("The uniform grid and all pairs in a gas: time of one collision step divided by the number of spheres, "
           "with the intervals of the medians. Warm: the spheres are in cell order; cold: in random order, so that "
           "each step sorts. A rising line is quadratic in $n$, a level one linear. The numbers at the end of the "
           "cold lines are the slope of the time itself between the two largest sizes (1 is linear). {crossovers}")
LINES = {"warm": "-", "cold": "--"}
FRACTIONS = (0.3, 0.05)


def sets(machine, backend, fraction):
    """(label, look, records) of each line: the grid in both orders, and all pairs."""
    wanted = {"table": TABLE, "scene": "uniform", "packing_fraction": fraction, "backend": backend}
    for order, line in LINES.items():
        rows = machine.select(**wanted, method="collide_grid", order=order)
        if rows:
            yield f"grid, {order}", {"linestyle": line}, rows
    rows = machine.select(**wanted, method="collide_triangle", order="cold")
    if rows:
        yield "all pairs", {"linestyle": ":", "alpha": 0.6}, rows


def cpu_line(machine, fraction):
    """The grid on all cores."""
    return machine.select(table=TABLE, scene="uniform", packing_fraction=fraction, backend="cpu",
                          method="collide_grid", order="cold")


def caption(machine):
    found = []
    for name in needed_devices(machine, table=TABLE):
        n = crossover(machine, name, 0.3)
        found.append(f"{SERIES[name]['label']}: {n:,}" if n else f"{SERIES[name]['label']}: nowhere")
    return CAPTION.format(crossovers="Least $n$ from which the cold grid is faster at packing fraction 0.3, "
                          "decided by their intervals: " + "; ".join(found) + ".")


def per_sphere(axis, rows, series, **look):
    """Nanoseconds per sphere."""
    if len({row.n for row in rows}) != len(rows):
        raise Missing(f"there are several records of {rows[0].label} for one number of spheres")
    for record in rows:
        plot(axis, [record], series, scale=1e6 / record.n, **{**look, "label": None, "linestyle": ""})
    axis.plot([r.n for r in rows], [1e6 * r.median / r.n for r in rows], **{**SERIES[series], **look})


def note_slope(axis, rows, below):
    """The slope of the time between the two largest sizes: 1 is linear. The two APIs' are above and below."""
    small, large = rows[-2:]
    axis.annotate(f"{slope(small, large):.2f}", (large.n, 1e6 * large.median / large.n),
                  xytext=(5, -6 if below else 1), textcoords="offset points", fontsize=6,
                  color=SERIES[small.backend]["color"])


def draw(machine):
    devices = needed_devices(machine, table=TABLE)
    fractions = [value for value in FRACTIONS if machine.select(table=TABLE, packing_fraction=value)]
    figure, axes = panels(PAGE, 2.5, len(fractions), sharey=True)
    for axis, fraction in zip(axes, fractions):
        for name in devices:
            for label, look, rows in sets(machine, name, fraction):
                per_sphere(axis, rows, name, **look, label=f"{SERIES[name]['label']}, {label}")
                if label == "grid, cold" and len(rows) > 1:
                    note_slope(axis, rows, below=name == devices[-1])
        base = cpu_line(machine, fraction)
        if base:
            per_sphere(axis, base, "cpu parallel", label=f"{SERIES['cpu parallel']['label']}, grid, cold")
        axis.set_yscale("log")
        plain_ticks(axis)
        spheres_in_decades(axis, [row.n for row in machine.need(table=TABLE, packing_fraction=fraction)])
        axis.set_title(f"packing fraction {fraction:g}", loc="left")
    axes[0].set_ylabel("time of one step per sphere (ns)")
    axes[-1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure
