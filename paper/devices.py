# SPDX-License-Identifier: MIT
"""The GPU APIs of which a machine has records."""
from paper.records import Missing

APIS = ("opengl", "vulkan", "cuda")  # in the order in which figures show them


def devices_of(machine):
    """Backends; Missing without any."""
    found = [name for name in APIS if machine.has(name)]
    if not found:
        raise Missing(f"{machine.name} has no OpenGL, Vulkan or CUDA: record it on a machine with one of them")
    return found
