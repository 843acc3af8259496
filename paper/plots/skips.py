# SPDX-License-Identifier: MIT
"""What each skip, each trick of one API and each library is worth: the same work with it and without."""
from derived import ratio
from records import Missing
from style import PAGE, SERIES, panels, series_of, time_text

NAME = TABLE = "skips"
CAPTION = ("What each skip, each trick of one API and each kernel of our own saves: time without it over time with it, "
           "the results being equal; left of 1 it costs. Bars: the least and greatest ratio that the intervals of both "
           "medians allow. On the right: the time with it, and what of a step's work is counted differently with it.")
KINDS = {"skip": "skips: work that the scene does not need", "trick": "tricks: what one API offers",
         "library": "our own kernel in place of a library's or the API's"}
TRICKS = ({"glsl"}, {"cuda"})  # who has them, alone
OF_BOTH = {"vector_loads"}  # tricks that both have


def same_work(record):
    """What an on and an off record have in common, apart from the number of spheres."""
    scene = tuple(sorted((name, str(value)) for name, value in record.scene.items() if name != "n"))
    return record.skip, record.backend, scene, record.parameters.get("method"), record.parameters.get("block")


def pairs_of(machine):
    """(with, without) for every option, backend and scene, at the largest number of spheres; by kind."""
    with_it = {same_work(row): row for row in machine.need(table=TABLE, on=True)}  # smallest n first: the last stays
    without = {(same_work(row), row.n): row for row in machine.select(table=TABLE, on=False)}
    pairs = [(on, without[work, on.n]) for work, on in with_it.items() if (work, on.n) in without]
    if not pairs:
        raise Missing(f"{machine.name} has no option that was timed both with and without")
    names = list(dict.fromkeys(on.skip for on, _ in pairs))
    return sorted(pairs, key=lambda pair: names.index(pair[0].skip))


def by_kind(pairs):
    """What one API alone has is a trick of it; what is named our own stands against a library or the API's function."""
    owners = {}
    for on, _ in pairs:
        owners.setdefault(on.skip, set()).add(on.backend)
    found = {kind: [] for kind in KINDS}
    for pair in pairs:
        skip = pair[0].skip
        trick = owners[skip] in TRICKS or skip in OF_BOTH
        kind = "library" if skip.startswith("own_") else "trick" if trick else "skip"
        found[kind].append(pair)
    return {kind: rows for kind, rows in found.items() if rows}


def label(record):
    scene = record.scene["name"]
    fraction = record.scene.get("packing_fraction")
    where = f"{scene} {fraction:g}" if scene == "uniform" and fraction else scene
    who = SERIES[series_of(record)]["label"].split(",")[0]
    return f"{record.skip.replace('_', ' ')}: {who}, {where}, n = {record.n:,}"


def remark(on, off):
    """E.g. 0.5 ms; sorts 0, not 1."""
    with_it, without = (record.parameters.get("work_a_step", {}) for record in (on, off))
    changed = [f"{name.replace('_', ' ')} {with_it[name]:g}, not {without[name]:g}" for name in with_it
               if with_it[name] != without.get(name)]
    return "; ".join([time_text(on.median), *changed])


def draw(machine):
    rows = [row for kind, pairs in by_kind(pairs_of(machine)).items() for row in (kind, *pairs)]
    figure, (axis,) = panels(PAGE, 0.6 + 0.15 * len(rows))
    for place, row in enumerate(reversed(rows)):
        if isinstance(row, str):
            continue
        on, off = row
        middle, below, above = ratio(off, on)
        axis.errorbar(middle, place, xerr=[[below], [above]], capsize=1.5, elinewidth=0.7,
                      **{**SERIES[series_of(on)], "label": None, "linestyle": ""})
        axis.text(1.01, place, remark(on, off), transform=axis.get_yaxis_transform(), fontsize=6, va="center")
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
