# SPDX-License-Identifier: MIT
"""One frame from each backend, and their difference. For each recorded backend:

  spherepair render --backend opengl --scene random --n 4096 --restitution 0.3 --steps 84 --size 640x480 --samples 9 \\
    --no-legend --output same-glsl.png
"""
import matplotlib.pyplot as plt
import numpy

from paper.images.animations import FOLDER, context_of, cropped, record
from paper.records import Missing
from paper.style import PAGE, panels

NAME = "same-frame"
CAPTION = ("One frame from {backends}, and the greatest difference of a channel at each pixel between any two, black for "
           "none: {said}.")
BACKENDS = ("cpu", "opengl", "cuda")
TITLES = {"cpu": "CPU", "opengl": "GLSL", "cuda": "CUDA"}


def recorded():
    names = [name for name in BACKENDS if (FOLDER / f"same-{name}.png").exists()]
    if len(names) < 2:
        raise Missing("one frame was not recorded from two backends")
    return names


def difference(images):
    stacked = numpy.stack([image[..., :3] for image in images])
    return (stacked.max(axis=0) - stacked.min(axis=0)).max(axis=-1)


def images():
    return [plt.imread(FOLDER / f"same-{name}.png") for name in recorded()]


def caption(machine):
    devices = [f"{TITLES[name]} ({record(f'same-{name}')['backends'][0]['device']})" for name in recorded()]
    off = int((difference(images()) > 0).sum())
    return CAPTION.format(backends=", ".join(devices), said="none" if off == 0 else f"{off} pixels differ")


def source(machine):
    return context_of(f"same-{recorded()[0]}")


def draw(machine):
    names, shown = recorded(), cropped(*images())
    figure, axes = panels(PAGE, 1.7, len(names) + 1)
    for axis, name, image in zip(axes, names, shown):
        axis.imshow(image)
        axis.set_title(TITLES[name], loc="left")
    axes[-1].imshow(difference(shown), cmap="gray", vmin=0, vmax=1 / 255)
    axes[-1].set_title("difference", loc="left")
    for axis in axes:
        axis.axis("off")
    return figure
