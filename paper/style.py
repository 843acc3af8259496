# SPDX-License-Identifier: MIT
"""The style of all figures: each series has its marker, line and grey level, readable in grey print."""
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator  # noqa: E402

COLUMN, PAGE = 3.4, 7.0  # inches: one column of the paper, both columns

SERIES = {
    "opengl": {"label": "OpenGL", "color": "#15396b", "marker": "o", "linestyle": "-"},
    "vulkan": {"label": "Vulkan", "color": "#b5322b", "marker": "v", "linestyle": "-."},
    "cuda": {"label": "CUDA", "color": "#e0812b", "marker": "s", "linestyle": "--", "markerfacecolor": "white"},
    "cpu parallel": {"label": "CPU, all threads", "color": "#5b8c5a", "marker": "^", "linestyle": ":"},
    "cpu sequential": {"label": "CPU, one thread", "color": "#8a8a8a", "marker": "D", "linestyle": ":"},
    "original parallel": {"label": "original paper, GLSL", "color": "black", "marker": "x", "linestyle": "-"},
    "original sequential": {"label": "original paper, one thread", "color": "black", "marker": "+", "linestyle": "--"},
}

plt.rcParams.update({
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 8, "axes.labelsize": 8,
    "axes.titlesize": 8, "legend.fontsize": 7, "xtick.labelsize": 7, "ytick.labelsize": 7, "lines.linewidth": 0.9,
    "lines.markersize": 3.6, "lines.markeredgewidth": 0.8, "axes.linewidth": 0.5, "axes.spines.top": False,
    "axes.spines.right": False, "xtick.major.width": 0.5, "ytick.major.width": 0.5, "xtick.minor.width": 0.3,
    "ytick.minor.width": 0.3, "legend.frameon": False, "grid.color": "#dddddd", "grid.linewidth": 0.4,
    "axes.grid": True, "axes.axisbelow": True, "pdf.fonttype": 42, "svg.hashsalt": "spherepair",
})


def series_of(record):
    """The series of a record: on the CPU, every method except `sequential` uses all threads."""
    if record.backend != "cpu":
        return record.backend
    return "cpu sequential" if record.parameters.get("method") == "sequential" else "cpu parallel"


def name_devices(machine):
    """Adds "in software" to the labels of APIs that run there."""
    for name, words in (("opengl", "OpenGL"), ("vulkan", "Vulkan")):
        SERIES[name]["label"] = f"{words} in software" if machine.has(name) and machine.backend(name)["software"] else words


def panels(width, height, columns=1, **options):
    figure, axes = plt.subplots(1, columns, figsize=(width, height), layout="constrained", squeeze=False, **options)
    return figure, list(axes[0])


def spheres_axis(axis, label="number of spheres $n$"):
    axis.set_xscale("log", base=2)
    axis.xaxis.set_major_formatter(FuncFormatter(lambda n, _: f"{n:,.0f}"))
    axis.xaxis.set_major_locator(LogLocator(base=4, numticks=12))
    axis.xaxis.set_minor_locator(NullLocator())
    axis.tick_params(axis="x", labelrotation=45)
    axis.set_xlabel(label)


def spheres_in_decades(axis, sizes, label="number of spheres $n$"):
    """For sizes over many orders of magnitude; otherwise spheres_axis()."""
    if max(sizes) < 1e5 * min(sizes):
        return spheres_axis(axis, label)
    axis.set_xscale("log")
    axis.xaxis.set_major_locator(LogLocator(numticks=12))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.set_xlabel(label)


def time_text(milliseconds):
    """Three significant digits, in a suitable unit."""
    for unit, least in (("s", 1e3), ("ms", 1.0), ("µs", 1e-3)):
        if milliseconds >= least:
            return f"{milliseconds / least:.3g} {unit}"
    return f"{1e6 * milliseconds:.3g} ns"


def plain_ticks(axis):
    """0.01, 0.1, 1, 10 instead of powers, and every one of them on a logarithmic axis."""
    if axis.get_yscale() == "log":
        axis.yaxis.set_major_locator(LogLocator(numticks=12))
        axis.yaxis.set_minor_formatter(NullFormatter())
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def plot(axis, records, series, x=lambda record: record.n, scale=1.0, **options):
    """Medians joined by a line, with their intervals as bars, which may be hidden by the markers."""
    look = {**SERIES[series], **options}
    middle = [record.median * scale for record in records]
    below = [(record.median - record.low) * scale for record in records]
    above = [(record.high - record.median) * scale for record in records]
    return axis.errorbar([x(record) for record in records], middle, yerr=[below, above], capsize=1.5,
                         elinewidth=0.7, capthick=0.5, **look)


def save(figure, folder, name, source):
    """A PDF for the paper, whose caption names the machine, and a PNG that names it in the image."""
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{name}.pdf", metadata={"CreationDate": None, "ModDate": None, "Producer": None})
    save_png(figure, folder / f"{name}.png", source)
    plt.close(figure)


def save_png(figure, file, source=""):
    if source:
        most = int(30 * figure.get_figwidth())  # characters of this size in a line
        lines = (wrapped for line in source.splitlines() for wrapped in textwrap.wrap(line, most))
        figure.supxlabel("\n".join(lines), x=0.99, ha="right", fontsize=4.8, color="#555555")
    figure.savefig(file, dpi=220, metadata={"Software": None})
