# SPDX-License-Identifier: MIT
"""Numbers of the prose about OpenGL, Vulkan and CUDA on the same work; `machine` is the folder `apis`."""
from paper.numbers import apis
from paper.records import said
from paper.text import ms

KEYS = {"OpenGL": "opengl", "Vulkan": "vulkan", apis.ONE_STEP: "cuda", apis.MANY_STEPS: "many"}


def span(low, high, digits):
    return f"{low:.{digits}f} to {high:.{digits}f}"


def short_steps(put, machine, others):
    run, steps = machine.source("launches.json")["id"], apis.short_steps(machine)
    put("apis/least", f"{steps.sizes[0]:,}", run, "fewest spheres of a short step")
    put("apis/most", f"{steps.sizes[-1]:,}", run, "most spheres of a short step")
    put("apis/extent", steps.extent, run, "what the ratios of the three APIs stand on")
    for way, key in KEYS.items():
        put(f"apis/short/{key}", span(*steps.times[way], 1), run, f"µs of a move and all pairs, fewest and most spheres: {way}")
    for way, bounds in steps.ratios.items():
        put(f"apis/over/{KEYS[way]}", f"{bounds[0]:.1f}x to {bounds[1]:.1f}x", run, f"least and greatest time of {way} over a CUDA graph of one step")
    said(machine, steps.ratios["Vulkan"][1] < steps.ratios["OpenGL"][0], "through Vulkan every short step is nearer to CUDA's than any through OpenGL")


def launch_costs(put, machine, others):
    run = machine.source("launches.json")["id"]
    for key, path in (("opengl", ("opengl", "batched")), ("vulkan", ("vulkan", "recorded_steps")), ("cuda", ("cuda", "graph"))):
        put(f"apis/cost/{key}", f"{apis.launch_cost(machine, *path):.1f}", run, f"µs of an empty kernel behind another: {key}")
    put("apis/model", f"{100 * apis.worst_error(machine):.0f}", run, "%, greatest error of the model, over both works and all sizes")
    grid = [(apis.fastest(found, "Vulkan", n), apis.fastest(found, apis.ONE_STEP, n)) for found in (apis.rows(machine, "grid"),)
            for n in apis.sizes(found, apis.SHORT)]
    said(machine, all(vulkan.median < cuda.median for vulkan, cuda in grid), "the grid of few spheres is faster in Vulkan than in a CUDA graph of one step")


def large_work(put, machine, others):
    contests = {contest.work: contest for contest in apis.contests(machine)}
    for key, work in (("contacts", "a step of a million spheres in contact"), ("contacts/large", "a step of 10 million spheres in contact"),
                      ("cold", "the same in random order")):
        for name, ratio in zip(apis.APIS, contests[work].ratios):
            put(f"apis/{key}/{name}", f"{ratio.middle:.2f}x", contests[work].records[0].source, f"{name} over CUDA: {work}")


def tensor_cores(put, machine, others):
    run = machine.source("sweep_tensor")["id"]
    n, times = apis.tensor_times(machine)
    put("apis/tensor/n", f"{n:,}", run, "spheres of all pairs with tensor cores")
    for (name, method), time in times.items():
        put(f"apis/tensor/{name}/{method}", ms(time), run, f"ms of all pairs by {method}, {name}")


def from_spirv(put, machine, others):
    run = machine.source("sweep_spirv")["id"]
    n, times = apis.spirv_times(machine)
    put("apis/spirv/n", f"{n:,}", run, "spheres searched by OpenGL's kernels from SPIR-V")
    for key, method in (("pairs", "collide_triangle"), ("grid", "collide_grid")):
        for name, backend in (("binary", "opengl-spirv"), ("text", "opengl-core")):
            put(f"apis/spirv/{key}/{name}", ms(times[backend, method]), run, f"ms of {method}, {backend}")
    slower = {method: times["opengl-spirv", method] / times["opengl-core", method] for method in ("collide_triangle", "collide_grid")}
    said(machine, slower["collide_triangle"] > slower["collide_grid"] > 1, "OpenGL's kernels from SPIR-V are slower, all pairs most")


COMPARED_APIS = (short_steps, launch_costs, large_work, tensor_cores, from_spirv)
