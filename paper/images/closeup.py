# SPDX-License-Identifier: MIT
"""The mesh of the original paper and exact spheres, close up:

  spherepair render --backend opengl --scene random --n 512 --steps 96 --size 640x480 --no-legend --draw mesh \\
    --eye 13,1,17 --target 3,-2,5 --field 24 --samples 9 --output closeup-mesh.png
  the same with --draw impostor --output closeup-impostor.png
"""
import matplotlib.pyplot as plt

from paper.images.animations import FOLDER, context_of
from paper.records import Missing
from paper.style import COLUMN, panels

NAME = "closeup"
CAPTION = ("(a) The original paper's sphere of 80 triangles; (b) the exact sphere on two triangles. The mesh lies "
           "inside its sphere, so touching spheres are drawn apart.")
FRAMES = ("closeup-mesh", "closeup-impostor")


def source(machine):
    return context_of(FRAMES[0])


def draw(machine):
    if not all((FOLDER / f"{name}.png").exists() for name in FRAMES):
        raise Missing("the close-up images were not recorded")
    figure, axes = panels(COLUMN, 1.4, 2)
    for letter, axis, name in zip("ab", axes, FRAMES):
        axis.imshow(plt.imread(FOLDER / f"{name}.png"))
        axis.set_title(f"({letter})", loc="left")
        axis.axis("off")
    return figure
