# SPDX-License-Identifier: MIT
"""Work-precision: the position of a record, the Pareto front, and the paper's method."""
from paper.records import Missing

PAPER = {"method": "paper", "precision": "float32", "dt": 1 / 64}  # equation 1 and code 1 at the step of this study


def study(machine, **wanted):
    """The records of the work-precision study: those with the most frequent n."""
    rows = machine.need(table="precision", **wanted)
    sizes = [row.n for row in machine.need(table="precision")]
    return [row for row in rows if row.n == max(sorted(set(sizes)), key=sizes.count)]


def seconds(row):
    """Run time of a simulated second, nanoseconds a sphere."""
    return 1e6 * row.median / row.n / row.dt


def front(rows):
    """Rows with less error than every faster one, fastest first."""
    kept = []
    for row in sorted(rows, key=lambda row: (seconds(row), row.error_m)):
        if not kept or row.error_m < kept[-1].error_m:
            kept.append(row)
    return kept


def kind(row):
    """Anchored motion with positions evaluated in every step counts as a method of its own."""
    return row.method if row.work == "move" else f"{row.method} {row.work.replace('move and', '+')}"


def devices(rows):
    return [name for name in ("cpu", "opengl", "cuda") if any(row.backend == name for row in rows)]


def paper_setting(rows):
    return [row for row in rows if all(row.parameters[name] == value for name, value in PAPER.items())]


def draw_front(axis, rows, **look):
    kept = front(rows)
    axis.plot([seconds(row) for row in kept], [row.error_m for row in kept], **look)


def mark_paper(axis, rows):
    for row in paper_setting(rows):
        axis.plot(seconds(row), row.error_m, marker="*", markersize=9, color="black", markerfacecolor="#f2d024",
                  linestyle="", zorder=5)


def same_time(rows):
    times = {row.simulated_s for row in rows}
    if len(times) != 1:
        raise Missing(f"errors were recorded after {sorted(times)} s; a diagram needs one time")
    return times.pop()
