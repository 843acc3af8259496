# SPDX-License-Identifier: MIT
"""A step through OpenGL, Vulkan and CUDA: its times, and how they follow from CUDA's and from what a launch costs."""
from dataclasses import dataclass

SHORT = 4096  # spheres of a step whose time is mostly launches
ONE_STEP = "CUDA, graph of a step"
MANY_STEPS = "CUDA, graphs of up to 64 steps"
# The paths of a way, of which the fastest counts. None waits for a launch.
WAYS = {"OpenGL": ("opengl", ("batched", "overlapping")),
        "Vulkan": ("vulkan", ("batched", "overlapping", "recorded_steps", "recorded_steps_overlapping")),
        "CUDA, stream": ("cuda", ("stream", "stream_programmatic")),
        ONE_STEP: ("cuda", ("graph", "graph_programmatic")),
        MANY_STEPS: ("cuda", ("graph_steps", "graph_steps_programmatic"))}
# Paths on which each launch waits for the one before. The model makes the others from the first. Vulkan's batches are left
# out: its empty kernels take as long as the host needs to record them.
DEPENDENT = (("cuda", "graph"), ("opengl", "batched"), ("vulkan", "recorded_steps"))


def rows(machine, work):
    """(backend, path, n) -> record."""
    return {(row.backend, row.path, row.n): row for row in machine.need(table="launches", work=work)}


def sizes(found, most=float("inf")):
    return sorted({n for _, _, n in found if n <= most})


def fastest(found, way, n):
    """The record of a way's fastest path; None if none was timed."""
    backend, paths = WAYS[way]
    timed = [found[backend, path, n] for path in paths if (backend, path, n) in found]
    return min(timed, key=lambda row: row.median, default=None)


def launch_cost(machine, backend, path):
    """µs of an empty kernel behind another."""
    return machine.one(table="launches", work="empty", backend=backend, path=path).us_per_kernel


@dataclass(frozen=True)
class Modelled:
    record: object
    time: float  # µs

    @property
    def error(self):
        """The model's time over the measured one, less 1."""
        return self.time / (1e3 * self.record.median) - 1


def modelled(machine, work):
    """CUDA's time of a step in a graph, and for each of its kernels what a launch costs more on the other path."""
    found = rows(machine, work)
    costs = {path: launch_cost(machine, *path) for path in DEPENDENT}
    first = DEPENDENT[0]
    return [Modelled(found[(*path, n)], 1e3 * graph.median + graph.work_per_step["kernels"] * (costs[path] - costs[first]))
            for n in sizes(found) if (graph := found.get((*first, n)))
            for path in DEPENDENT[1:] if (*path, n) in found]
