# SPDX-License-Identifier: MIT
"""The ids of backends: what records of before called them, and where the sources of each are."""
import re

KERNELS = {"opengl": "glsl", "opengl-core": "glsl", "opengl-spirv": "glsl", "vulkan": "glsl", "cuda": "cuda"}  # in the names of digests
HOSTS = {**KERNELS, "vulkan": "vulkan", "cpu": "cpu"}
# Where a line or a text of JSON begins: "glsl", "glsl-core collide_tiled 64", glsl: energy.
OLD = re.compile(r'(^|")glsl(?=(?:-core)?(?:[" :]|$))', re.MULTILINE)
OLD_TEST = re.compile(r"/glsl\b")  # in the names of tests


def today(text):
    """A record's text by the ids of today."""
    return OLD.sub(r"\1opengl", text)
