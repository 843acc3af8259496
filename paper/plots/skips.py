# SPDX-License-Identifier: MIT
"""What each skip, each trick of one API and each library is worth: the same work with it and without."""
from derived import ratio
from style import PAGE, SERIES, panels, series_of, time_text

NAME = TABLE = "skips"
CAPTION = ("What each skip, each trick of one API and each library saves: time without it over time with it, the "
           "results being equal; left of 1 it costs. Bars: the least and greatest ratio that the intervals of both "
           "medians allow. On the right: the time with it and, where it was counted, what it saved.")
KINDS = {"skip": "skips: work that the scene does not need", "trick": "tricks: what one API offers",
         "library": "libraries in place of our kernel"}


def same_work(record):
    """What an on and an off record have in common, apart from the number of spheres."""
    scene = tuple(sorted((name, str(value)) for name, value in record.scene.items() if name != "n"))
    return record.skip, record.backend, scene, record.parameters.get("method"), record.parameters.get("block")


def pairs_of(machine):
    """(with, without) for every option, backend and scene, at the largest number of spheres; by kind."""
    with_it = {same_work(row): row for row in machine.need(table=TABLE, on=True)}  # smallest n first: the last stays
    without = {(same_work(row), row.n): row for row in machine.select(table=TABLE, on=False)}
    pairs = [(on, without[work, on.n]) for work, on in with_it.items() if (work, on.n) in without]
    names = list(dict.fromkeys(on.skip for on, _ in pairs))
    return sorted(pairs, key=lambda pair: (list(KINDS).index(kind_of(pair[0])), names.index(pair[0].skip)))


def kind_of(record):
    return record.parameters.get("kind", "skip")


def label(record):
    scene = record.scene["name"]
    fraction = record.scene.get("packing_fraction")
    where = f"{scene} {fraction:g}" if scene == "uniform" and fraction else scene
    return f"{record.skip}: {SERIES[series_of(record)]['label'].split(',')[0]}, {where}, n = {record.n:,}"


def remark(on):
    counter = on.parameters.get("counter")
    counted = f"; {counter['name']}: {counter['on']:,} of {counter['off']:,}" if counter else ""
    return time_text(on.median) + counted


def draw(machine):
    pairs = pairs_of(machine)
    kinds = [kind for kind in KINDS if any(kind_of(on) == kind for on, _ in pairs)]
    rows = [row for kind in kinds for row in (kind, *(pair for pair in pairs if kind_of(pair[0]) == kind))]
    figure, (axis,) = panels(PAGE, 0.6 + 0.15 * len(rows))
    for place, row in enumerate(reversed(rows)):
        if isinstance(row, str):
            continue
        on, off = row
        middle, below, above = ratio(off, on)
        axis.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7,
                      **{**SERIES[series_of(on)], "label": None, "linestyle": ""})
        axis.text(1.01, place, remark(on), transform=axis.get_yaxis_transform(), fontsize=6, va="center")
    axis.set_yticks(range(len(rows)), [KINDS[row] if isinstance(row, str) else label(row[0])
                                       for row in reversed(rows)])
    for tick, row in zip(axis.get_yticklabels(), reversed(rows)):
        tick.set_fontweight("bold" if isinstance(row, str) else "normal")
    axis.axvline(1, color="black", linewidth=0.6)
    axis.set_xscale("log", base=2)
    axis.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.tick_params(axis="y", length=0)
    axis.set_xlabel("time without / time with")
    axis.grid(axis="y", visible=False)
    return figure
