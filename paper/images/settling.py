# SPDX-License-Identifier: MIT
"""Spheres falling on the plane, from one run of `spherepair render`:

  spherepair render --backend cpu --scene random --n 4096 --restitution 0.3 --images 4 --every 56 --size 640x640 \\
    --samples 9 --no-legend --output settling.png
"""
import matplotlib.pyplot as plt

from paper.images.animations import FOLDER, context_of, cropped, record
from paper.records import Missing
from paper.style import PAGE, panels

NAME = "settling"
CAPTION = ("Spheres falling on the plane, restitution {restitution}, coloured by their contacts: blue none, then from "
           "pale yellow to dark red for seven and more. {frames}. Ambient occlusion and shadows use the same cells "
           "as the contacts.")
FRAMES = tuple(f"settling-{k}" for k in range(4))


def caption(machine):
    frames = [record(name) for name in FRAMES]
    said = "; ".join(f"({letter}) step {frame['step']}, {frame['pairs']:,} pairs" for letter, frame in
                     zip("abcd", frames))
    return CAPTION.format(restitution=round(frames[0]["restitution"], 6), frames=said)


def source(machine):
    return context_of(FRAMES[0])


def draw(machine):
    if not all((FOLDER / f"{name}.png").exists() for name in FRAMES):
        raise Missing("the images of the falling spheres were not recorded")
    figure, axes = panels(PAGE, 1.9, len(FRAMES))
    shown = cropped(*(plt.imread(FOLDER / f"{name}.png") for name in FRAMES))
    for letter, axis, image in zip("abcd", axes, shown):
        axis.imshow(image)
        axis.set_title(f"({letter})", loc="left")
        axis.axis("off")
    return figure
