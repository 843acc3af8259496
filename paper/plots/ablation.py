# SPDX-License-Identifier: MIT
"""What each optimisation, each API feature and each kernel of our own saves: the same work on and off."""
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from paper.numbers.ablations import pairs_of
from paper.numbers.derived import ratio
from paper.records import named
from paper.style import PAGE, SERIES, panels, series_of, time_text
from paper.text import APIS

NAME = "ablation"
CAPTION = ("Ablation of each optimisation, API feature and own kernel (in place of a library's): time without over time with it, at equal "
           "results; left of 1 it costs. Bars: the interval of the ratio. "
           "Right: the time with it{counted}.")
COUNTED = ", and the counts of a step's work that differ, with it and (in brackets) without"
KINDS = {"work": "optimisations", "api": "API features", "library": "own kernels"}
ONE_API = ({"opengl"}, {"cuda"})
OF_BOTH = {"vector_loads", "overlap"}  # API features that both have
MOST_SIZES = 2


def source(machine):
    return named(machine, [on for on, _ in pairs_of(machine)])


def sizes_of(pairs):
    """The largest numbers of spheres; of GPUs if there are any."""
    shown = [on.n for on, _ in pairs if on.backend != "cpu"] or [on.n for on, _ in pairs]
    return sorted(set(shown))[-MOST_SIZES:]


def lines_of(pairs):
    """Headings, and (option, scene) below them. An option of a single API is an API feature; one named own_... replaces a
    library or the API's function."""
    owners = {}
    for on, _ in pairs:
        owners.setdefault(on.option, set()).add(on.backend)
    found = {kind: {} for kind in KINDS}
    for on, _ in pairs:
        api = owners[on.option] in ONE_API or on.option in OF_BOTH
        kind = "library" if on.option.startswith("own_") else "api" if api else "work"
        found[kind][on.option, scene_of(on)] = None
    return [line for kind, lines in found.items() if lines for line in (KINDS[kind], *lines)]


def scene_of(record):
    fraction = record.scene.get("packing_fraction")
    name = record.scene["name"]
    return f"{name} {fraction:g}" if name == "uniform" and fraction else name


def counts(on, off):
    """E.g. sorts 0 (1). Launches are shown for graphs only: otherwise they depend on what a graph can hold; overlapped
    launches are shown for the option overlap only."""
    with_it, without = (record.parameters.get("work_per_step", {}) for record in (on, off))
    shown = [name for name in with_it if "graph" in on.option or name not in ("launches", "graphs_replayed")
            if on.option == "overlap" or name != "overlapped"]
    return ", ".join(f"{name.replace('_', ' ')} {in_short(with_it[name])} ({in_short(without.get(name, 0))})"
                     for name in shown if with_it[name] != without.get(name))


def in_short(count):
    """Four digits at most: 26.4, 6842, 7.6M."""
    for unit, size in (("M", 1e6), ("k", 1e4)):
        if count >= size:
            return f"{count / (1e6 if unit == 'M' else 1e3):.3g}{unit}"
    return f"{count:.4g}" if count >= 1000 else f"{count:.3g}"


def draw_line(axis, place, pairs, last):
    times, counted = [], []
    for k, (on, off) in enumerate(pairs):
        middle, below, above = ratio(off, on)
        axis.errorbar(middle, place + 0.17 * (len(pairs) - 1 - 2 * k), xerr=[[below], [above]], capsize=1.2,
                      elinewidth=0.7, **{**SERIES[series_of(on)], "label": None, "linestyle": "", "markersize": 3})
        times.append(f"{APIS[on.backend]} {time_text(on.median)}")
        counted.append(counts(on, off))
    texts = ["; ".join(times), *(counted[-1:] if last and counted[-1] else [])]
    axis.text(1.02, place, ". ".join(texts), transform=axis.get_yaxis_transform(), fontsize=5.8, va="center")


def caption(machine):
    counted = any(counts(*pair) for pair in pairs_of(machine))
    return CAPTION.format(counted=COUNTED if counted else "")


def set_axis(axis, lines, common):
    labels = [line if isinstance(line, str) else line[0].replace("_", " ") +
              ("" if line[1] == common else f", {line[1]}") for line in lines]
    axis.set_yticks(range(len(lines)), reversed(labels))
    for tick, line in zip(axis.get_yticklabels(), reversed(lines)):
        tick.set_fontweight("bold" if isinstance(line, str) else "normal")
    axis.axvline(1, color="black", linewidth=0.6)
    axis.set_xscale("log")
    low, high = axis.get_xlim()
    axis.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 30 * low else (1, 3), numticks=12))
    axis.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.tick_params(axis="y", length=0)
    axis.set(xlabel="time without / time with", ylim=(-0.7, len(lines) - 0.3))
    axis.grid(axis="y", visible=False)


def keys(pairs):
    found = dict.fromkeys(series_of(on) for on, _ in pairs)
    return [Line2D([], [], **{**SERIES[name], "linestyle": ""}) for name in found]


def draw(machine):
    pairs = pairs_of(machine)
    sizes, lines = sizes_of(pairs), lines_of(pairs)
    pairs = [pair for pair in pairs if pair[0].n in sizes]
    scenes = [scene_of(on) for on, _ in pairs]
    common = max(sorted(set(scenes)), key=scenes.count)
    figure, axes = panels(PAGE, 0.6 + 0.15 * len(lines), len(sizes), sharey=True)
    for n, axis in zip(sizes, axes):
        for place, line in enumerate(reversed(lines)):
            own = [pair for pair in pairs if pair[0].n == n and (pair[0].option, scene_of(pair[0])) == line]
            if own:
                draw_line(axis, place, own, last=n == sizes[-1])
        set_axis(axis, lines, common)
        axis.set_title(f"$n$ = {n:,}, {common}", loc="left")
    figure.legend(handles=keys(pairs), loc="lower left")
    return figure
