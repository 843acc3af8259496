# SPDX-License-Identifier: MIT
"""The original paper's figure 6: a frame of each of its animations, from `spherepair render`:

  spherepair render --backend cpu --scene random --n 512 --steps 96 --size 640x480 --no-legend --output random.png
  spherepair render --backend cpu --scene aligned --groups 8 --group-size 64 --n 512 --steps 96 ... --output aligned.png
"""
import json

import matplotlib.pyplot as plt
import numpy

from paper import ids
from paper.records import DATA, Missing
from paper.style import COLUMN, panels

NAME = "animations"
CAPTION = ("The original paper's figure 6: {frames}. Colour: number of contacts, from yellow to "
           "red. The CPU and software GLSL draw the same bytes.")
FOLDER = DATA / "animations"
FRAMES = ("random", "aligned")


def record(name):
    path = FOLDER / f"{name}.json"
    if not path.exists():
        raise Missing(f"{path.relative_to(DATA)} was not recorded")
    return json.loads(ids.today(path.read_text()))


def describe(letter, frame):
    return (f"({letter}) {frame['scene']['name']}, {frame['scene']['n']} spheres after {frame['step']} steps, "
            f"{frame['pairs']} pairs")


def caption(machine):
    return CAPTION.format(frames="; ".join(describe(letter, record(name)) for letter, name in zip("ab", FRAMES)))


def context_of(name):
    """The device and commit that drew the image, which is not a measurement."""
    context = record(name)["context"]
    return f"Drawn on {context['machine']['cpu']}, commit {context['build']['commit'][:12]}"


def source(machine):
    return context_of(FRAMES[0])


def cropped(*images):
    """Without the white border that all of them have."""
    darkest = numpy.min([image[..., :3].min(axis=2) for image in images], axis=0)
    inside = numpy.argwhere(darkest < 0.98)
    (top, left), (bottom, right) = inside.min(axis=0), inside.max(axis=0)
    return [image[top:bottom + 1, left:right + 1] for image in images]


def draw(machine):
    if not all((FOLDER / f"{name}.png").exists() for name in FRAMES):
        raise Missing("the images of the animations were not recorded")
    figure, axes = panels(COLUMN, 1.4, 2)
    for letter, axis, name in zip("ab", axes, FRAMES):
        record(name)
        axis.imshow(cropped(plt.imread(FOLDER / f"{name}.png"))[0])
        axis.set_title(f"({letter})", loc="left")
        axis.axis("off")
    return figure
