# SPDX-License-Identifier: MIT
"""One frame from each backend, and their difference. For every backend of BACKENDS that was recorded:

  spherepair render --backend glsl --scene random --n 4096 --restitution 0.3 --steps 84 --size 640x480 --samples 9 \\
    --no-legend --output same-glsl.png
"""
import matplotlib.pyplot as plt
import numpy

from plots.animations import FOLDER, context_of, record
from records import Missing
from style import PAGE, panels

NAME = "same_frame"
CAPTION = ("One frame from {backends}, and the greatest difference of a channel at each pixel between any two: {said}.")
BACKENDS = ("cpu", "glsl", "cuda")
TITLES = {"cpu": "CPU", "glsl": "GLSL", "cuda": "CUDA"}


def recorded():
    names = [name for name in BACKENDS if (FOLDER / f"same-{name}.png").exists()]
    if len(names) < 2:
        raise Missing("one frame was not recorded from two backends")
    return names


def difference(pictures):
    stacked = numpy.stack([picture[..., :3] for picture in pictures])
    return (stacked.max(axis=0) - stacked.min(axis=0)).max(axis=-1)


def pictures():
    return [plt.imread(FOLDER / f"same-{name}.png") for name in recorded()]


def caption(machine):
    devices = [f"{TITLES[name]} ({record(f'same-{name}')['backends'][0]['device']})" for name in recorded()]
    off = int((difference(pictures()) > 0).sum())
    return CAPTION.format(backends=", ".join(devices), said="none" if off == 0 else f"{off} pixels differ")


def source(machine):
    return context_of(f"same-{recorded()[0]}")


def draw(machine):
    names, shown = recorded(), pictures()
    figure, axes = panels(PAGE, 1.7, len(names) + 1)
    for axis, name, picture in zip(axes, names, shown):
        axis.imshow(picture)
        axis.set_title(TITLES[name], loc="left")
    axes[-1].imshow(difference(shown), cmap="gray", vmin=0, vmax=1 / 255)
    axes[-1].set_title("difference", loc="left")
    for axis in axes:
        axis.axis("off")
    return figure
