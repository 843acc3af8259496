# SPDX-License-Identifier: MIT
"""Each kernel's time ratio OpenGL/CUDA, by device timers."""
from paper.numbers.derived import stage_ratios
from paper.records import Missing
from paper.style import PAGE, panels, time_text

NAME = "kernel-pairs"
CAPTION = ("Each kernel's time through OpenGL over its time through CUDA by device timers (GL timer queries, CUDA events), at the "
           "largest recorded size; of several such records in the latest run, the one with the tightest bounds. "
           "Right of 1 CUDA is faster. Bars: of several processes the \\given{95}\\,\\% interval over them, of one the bounds from the "
           "intervals of both medians; an arrow where a bar is cut off. Right: CUDA's time. Only kernels that read at least ten "
           "times an empty one's time in both APIs.")
TASKS = {"motion": ("move", "bounce", "evaluate_"), "the grid": ("grid_", "split_", "collide_grid", "collide_hashed"),
         "drawing": ("draw_",), "peak rates": ("peak_",)}
REST = "all pairs, and common to all steps"
COLUMNS = ((REST, "drawing"), ("motion", "the grid", "peak rates"))


def source(machine):
    """The kernels may come from several runs."""
    return machine.short.replace(machine.id, ", ".join(dict.fromkeys(row.source for row in stage_ratios(machine))))


def task_of(kernel):
    return next((task for task, starts in TASKS.items() if kernel.startswith(starts)), REST)


def column_rows(rows, tasks):
    """Headings (text) and ratios, from the top."""
    return [line for task in tasks for line in (task, *(row for row in rows if task_of(row.kernel) == task))]


def draw_ratio(axis, place, row, limit):
    middle, below, above = row.ratio
    axis.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7, marker="o", color="#15396b")
    for beyond, edge, arrow in ((middle - below < 1 / limit, 1 / limit, "<"), (middle + above > limit, limit, ">")):
        if beyond:
            axis.plot(edge, place, marker=arrow, color="#15396b", markersize=4, clip_on=False)
    axis.text(1.05, place, time_text(row.cuda_ms), transform=axis.get_yaxis_transform(), fontsize=6, va="center")


def draw_column(axis, lines, height, limit):
    rows = [height - 1 - k for k in range(len(lines))]
    for place, line in zip(rows, lines):
        if not isinstance(line, str):
            draw_ratio(axis, place, line, limit)
    axis.set_yticks(rows, [line if isinstance(line, str) else f"{line.kernel}, {line.where}" for line in lines])
    for tick, line in zip(axis.get_yticklabels(), lines):
        tick.set_fontweight("bold" if isinstance(line, str) else "normal")
    axis.axvline(1, color="black", linewidth=0.7)
    axis.set(xscale="log", xlim=(1 / limit, limit), ylim=(-0.7, height - 0.3), xlabel="OpenGL time / CUDA time")
    ticks = [value for value in (0.25, 0.5, 0.7, 1, 1.4, 2, 4) if 1 / limit <= value <= limit]
    axis.set_xticks(ticks, [f"{value:g}" for value in ticks])
    axis.set_xticks([], minor=True)
    axis.tick_params(axis="y", length=0)
    axis.grid(axis="y", visible=False)


def draw(machine):
    rows = list(stage_ratios(machine))
    if not rows:
        raise Missing(f"{machine.name} has no kernel with device times and their intervals through both APIs")
    columns = [column_rows(rows, tasks) for tasks in COLUMNS]
    height = max(len(lines) for lines in columns)
    limit = 1.15 * max(2.0, *(max(row.ratio[0], 1 / row.ratio[0]) for row in rows))  # includes every ratio
    figure, axes = panels(PAGE, 0.6 + 0.125 * height, 2)
    for axis, lines in zip(axes, columns):
        draw_column(axis, lines, height, limit)
    return figure
