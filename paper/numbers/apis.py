# SPDX-License-Identifier: MIT
"""A step through OpenGL, Vulkan and CUDA: its times, and how they follow from CUDA's and from what a launch costs."""
from dataclasses import dataclass

from paper.numbers.ratios import extent, family

MANY = 10**7
GRID = {"table": "grid", "n": MANY, "scene": "uniform", "packing_fraction": 0.3, "method": "collide_grid"}
STEPS = (1024, 16384)  # spheres that are moved and tested against each other
WORKS = {"find the pairs of 10 million spheres, already sorted": {**GRID, "order": "warm"},
         "the same in random order": {**GRID, "order": "cold"},
         "a step of a million spheres in contact": {"table": "gas_steps", "n": 10**6},
         "a step of 10 million spheres in contact": {"table": "gas_steps", "n": MANY},
         "draw 10 million spheres at 1920x1080": {"table": "draw", "n": MANY, "draw": "compute", "work": "frame", "place": "outside"}}
APIS = ("opengl", "vulkan", "cuda")
SHORT = 4096  # spheres of a step whose time is mostly launches
ONE_STEP = "CUDA, graph of a step"
MANY_STEPS = "CUDA, graphs of up to 64 steps"
# The paths of a way, of which the fastest counts. None waits for a launch.
WAYS = {"OpenGL": ("opengl", ("batched", "overlapping")),
        "Vulkan": ("vulkan", ("batched", "overlapping", "recorded_steps", "recorded_steps_overlapping")),
        "CUDA, stream": ("cuda", ("stream", "stream_programmatic")),
        ONE_STEP: ("cuda", ("graph", "graph_programmatic")),
        MANY_STEPS: ("cuda", ("graph_steps", "graph_steps_programmatic"))}
# Paths whose launches wait for each other. The model starts from the first and predicts the others. Vulkan's batches are
# left out: there an empty kernel takes as long as the host needs to record it.
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


def step_ms(record):
    """A contest of contacts times many steps at once."""
    return record.median / record.parameters.get("steps", 1) if record.table == "gas_steps" else record.median


@dataclass(frozen=True)
class Contest:
    work: str
    records: tuple  # of APIS
    ratios: tuple  # of the first two over CUDA's


def contests(machine):
    """The three on the same work, each on its fastest path. The ratios are one family for Holm's correction."""
    found, ways = rows(machine, "all_pairs"), ("OpenGL", "Vulkan", MANY_STEPS)
    works = {f"move {n:,} spheres and test all pairs": tuple(fastest(found, way, n) for way in ways) for n in STEPS}
    works |= {work: tuple(machine.one(backend=name, **wanted) for name in APIS) for work, wanted in WORKS.items()}
    ratios = family([(record, cuda) for *others, cuda in works.values() for record in others])
    return [Contest(work, records, tuple(ratios[2 * k:2 * k + 2])) for k, (work, records) in enumerate(works.items())]


@dataclass(frozen=True)
class ShortSteps:
    sizes: list
    times: dict  # way -> µs at the first and the last size
    ratios: dict  # way -> the least and the greatest over CUDA's graph of one step
    extent: str


def short_steps(machine):
    """A move and all pairs of few spheres, each API on its fastest path."""
    found = rows(machine, "all_pairs")
    of_short = sizes(found, SHORT)
    steps = {way: [fastest(found, way, n) for n in of_short] for way in WAYS}
    ratios = {way: family(list(zip(steps[way], steps[ONE_STEP]))) for way in ("OpenGL", "Vulkan")}
    spans = {way: tuple(bound(ratio.middle for ratio in own) for bound in (min, max)) for way, own in ratios.items()}
    return ShortSteps(of_short, {way: (1e3 * own[0].median, 1e3 * own[-1].median) for way, own in steps.items()}, spans,
                      extent(sum(ratios.values(), [])))


def worst_error(machine):
    """Of the model, over both works and all sizes."""
    return max(abs(each.error) for work in ("all_pairs", "grid") for each in modelled(machine, work))


def tensor_times(machine):
    """(spheres, {(API, method): ms}) of all pairs with tensor cores and without."""
    n = max(row.n for row in machine.need(table="tensor", method="collide_tensor"))
    return n, {(name, method): machine.one(table="tensor", backend=name, method=f"collide_{method}", n=n).median
               for name in ("vulkan", "cuda") for method in ("tensor", "triangle")}


def spirv_times(machine):
    """(spheres, {(backend, method): ms}) of OpenGL's kernels from their text and from SPIR-V."""
    rows = machine.need(table="spirv")
    return rows[0].n, {(row.backend, row.method): row.median for row in rows}


def first_uses(machine):
    """API -> what opening it and its first search cost, each in a process of its own without the driver's cache."""
    return {name: next(backend["first_use"] for backend in machine.source(f"first_use_{name}.json")["backends"]) for name in APIS}


def compile_seconds(machine):
    """API -> seconds of the driver, and in Vulkan of glslang, for every kernel once. CUDA's are compiled when the program is built."""
    return {backend["name"]: sum(backend["compile_ms"].values()) / 1e3 for backend in machine.source("compile.json")["backends"]
            if backend.get("compile_ms")}
