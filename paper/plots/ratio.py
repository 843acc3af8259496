# SPDX-License-Identifier: MIT
"""Time ratio OpenGL/CUDA against the number of spheres and per method."""
from paper.numbers.derived import matched, ratio
from paper.style import PAGE, panels, spheres_axis

NAME = "glsl-against-cuda"
CAPTION = ("OpenGL's time over CUDA's for the same work: above 1 CUDA is faster, below 1 OpenGL. (a) Against the number of "
           "spheres: all pairs by the upper triangle, alone and as part of a whole step. (b) Per method at one "
           "size, groups of 128. Bars: the interval of the ratio.")
SETS = (("pairs, original box", "o", "#15396b", {"table": "scale", "scene": "random"}),
        ("pairs, gas of packing fraction 0.3", "s", "#e0812b", {"table": "scale", "scene": "uniform"}),
        ("whole step, original box", "^", "#5b8c5a", {"table": "step"}))
METHODS = ("collide_group", "collide_tiled", "collide_square", "collide_triangle")


def bars(axis, positions, ratios, **look):
    middle, below, above = zip(*ratios)
    axis.errorbar(positions, middle, yerr=[below, above], capsize=1.5, elinewidth=0.7, capthick=0.5, **look)


def draw(machine):
    figure, (sizes, methods) = panels(PAGE, 2.2, 2, width_ratios=[1.7, 1])
    for label, marker, color, wanted in SETS:
        pairs = matched(machine, **wanted)
        fill = "white" if marker == "s" else color
        bars(sizes, [glsl.n for glsl, _ in pairs], [ratio(*pair) for pair in pairs], label=label, marker=marker,
             color=color, markerfacecolor=fill, linestyle="-" if marker == "o" else "--" if marker == "s" else ":")
    spheres_axis(sizes)
    sizes.legend(loc="upper right")
    for k, method in enumerate(METHODS):
        pair = [machine.one(table="methods", method=method, backend=name, block=128) for name in ("opengl", "cuda")]
        bars(methods, [k], [ratio(*pair)], marker="o", color="#15396b")
        n = pair[0].n
    methods.set_xticks(range(len(METHODS)), [name.removeprefix("collide_") for name in METHODS])
    methods.set_xlim(-0.5, len(METHODS) - 0.5)
    methods.set_xlabel(f"method, $n$ = {n:,}")
    for axis, title in ((sizes, "(a)"), (methods, "(b)")):
        axis.axhline(1, color="black", linewidth=0.7)
        axis.set_ylabel("OpenGL time / CUDA time")
        axis.set_title(title, loc="left")
        low, high = axis.get_ylim()
        axis.set_ylim(min(low, 1 - 0.14 * (high - 1)), high)
        for name, offset, side in (("CUDA", 1.5, "bottom"), ("OpenGL", -2, "top")):
            axis.annotate(f" {name} faster", (0.01, 1.0), xycoords=axis.get_yaxis_transform(), xytext=(0, offset),
                          textcoords="offset points", va=side, fontsize=6.5)
    return figure
