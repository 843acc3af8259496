# SPDX-License-Identifier: MIT
"""Numbers of the prose about what limits the kernels, and about what only one API can express."""
from paper.numbers.derived import matched
from paper.numbers.ratios import time_ratio
from paper.numbers.sets import sets
from paper.records import said
from paper.text import ms

GPU = ("opengl", "cuda")
ISSUE, LOADS, MEMORY = "smsp__issue_active", "l1tex__data_pipe_lsu_wavefronts", "dram__cycles_active"
NAMES = {ISSUE: "issue slots", LOADS: "loads of L1", MEMORY: "memory", "lts__t_tag_requests": "tags of L2"}


def counters(machine):
    """One entry a kernel, size and order."""
    return machine.source("counters.json")["counters"]


def largest(rows):
    """Most spheres of the grid."""
    return max(row["n"] for row in rows if row["kernel"] == "collide_grid")


def limits_of_the_grid(put, machine, others):
    """The search issues and loads near to its limits, only the kernels that sort are bound by memory."""
    source, rows = machine.source("counters.json")["id"], counters(machine)
    n = largest(rows)
    search, = (row for row in rows if (row["kernel"], row["n"], row["order"]) == ("collide_grid", n, "warm"))
    sort = [row for row in rows if row["n"] == n and row["kernel"] not in ("collide_grid", "collide_triangle")]
    loads = search["limits"][LOADS]
    said(machine, search["dram_percent"] < min(search["issue_slots_percent"], loads), "memory is not what the grid's search is nearest to")
    said(machine, all(row["nearest_limit"] == MEMORY for row in sort), "memory is what the kernels that sort are nearest to")
    put("limit/n", f"{n:,}", source, "most spheres whose kernels in CUDA were profiled")
    put("limit/search/us", f"{1e-3 * search['time_ns']:.0f}", source, f"us, collide_grid, n = {n}, warm")
    for key, value in (("issue", search["issue_slots_percent"]), ("loads", loads), ("memory", search["dram_percent"])):
        put(f"limit/search/{key}", f"{value:.0f}", source, f"% of the peak, collide_grid, n = {n}, warm: {key}")
    shares = [row["dram_percent"] for row in sort]
    put("limit/sort/memory", f"{min(shares):.0f} to {max(shares):.0f}", source, f"% of memory's peak, the kernels that sort, n = {n}")


def tensor_cores(put, machine, others):
    """CUDA's search through tensor cores, which GLSL cannot express, in a run of CUDA alone."""
    rows = {(row.method, row.n): row for row in machine.need(table="tensor", backend="cuda")}
    pairs = {n: (rows["collide_triangle", n], rows["collide_tensor", n]) for method, n in rows if method == "collide_tensor"}
    faster = [n for n, (triangle, tensor) in pairs.items() if time_ratio(triangle, tensor).low > 1]
    most = max(pairs)
    said(machine, most in faster and set(faster) == {n for n in pairs if n >= min(faster)}, "tensor cores are faster from some size on")
    triangle, tensor = pairs[most]
    glsl = machine.one(table="scale", scene="uniform", backend="opengl", n=most)
    said(machine, tensor.median < glsl.median, "with tensor cores CUDA takes less time than GLSL")
    put("tensor/from", f"{min(faster):,}", tensor.source, "least spheres of a gas that tensor cores search faster than triangle")
    put("tensor/n", f"{most:,}", tensor.source, "most spheres searched through tensor cores")
    for key, row in (("cuda", tensor), ("triangle", triangle), ("opengl", glsl)):
        put(f"tensor/{key}", ms(row.median), row.source, f"ms, {row.label}, n = {most}, gas")
    put("tensor/gain", f"{time_ratio(triangle, tensor).middle:.1f}x", tensor.source, f"time of triangle over that of tensor cores, CUDA, n = {most}")
    put("tensor/over-glsl", f"{glsl.median / tensor.median:.1f}x", f"{glsl.source}, {tensor.source}",
        f"time of triangle in GLSL over that of tensor cores in CUDA, of two runs, n = {most}")


def drawn_frames(put, machine, others):
    found = [(time_ratio(*pair).middle, pair[1].source) for work in ("frame", "loop") for place in ("outside", "inside")
             for pair in matched(machine, table="draw", draw="compute", work=work, place=place)]
    values = [ratio for ratio, _ in found]
    said(machine, max(values) > 1, "in some frames or loops GLSL takes longer")
    put("draw/ratios", f"{min(values):.2f}x to {max(values):.2f}x", ", ".join(dict.fromkeys(source for _, source in found)),
        "time ratios GLSL/CUDA of the rasteriser's frames, alone and with a step before each")


def exactness_far_away(put, machine, others):
    root = sets(machine)
    far = {entry["backend"]: entry for entry in root["exactness"] if entry["scene"] == "far" and entry["backend"] in GPU}
    costs = [100 * (entry["exact"]["median_ms"] / entry["naive"]["median_ms"] - 1) for entry in far.values()]
    said(machine, min(costs) > 5, "far from the origin exactness costs a GPU more than a few percent")
    said(machine, all(entry["missed"] + entry["extra"] <= 1e-4 * entry["right"] for entry in far.values()),
         "far from the origin the naive comparison is hardly ever wrong")
    put("naive/far/cost", f"{min(costs):.0f} to {max(costs):.0f}", root["id"], "%, cost of exactness far from the origin, GLSL and CUDA")


def wider_arrangements(put, machine, others):
    """Two dimensions against one where the spheres fill the GPU better, in the sweep."""
    wanted = {"table": "grid", "scene": "uniform", "packing_fraction": 0.3, "order": "cold"}
    for name in GPU:
        tiled, square = ({row.n: row for row in machine.need(**wanted, backend=name, method=f"collide_{method}")} for method in ("tiled", "square"))
        n = max(tiled.keys() & square.keys())
        gain = tiled[n].median / square[n].median
        put(f"gain/wide/{name}", f"{gain:.1f}", square[n].source, f"time of tiled over that of square, {name}, n = {n}, gas")
        put(f"gain/wide/{name}/n", f"{n:,}", square[n].source, "spheres of that")


LIMITS = (limits_of_the_grid, tensor_cores, drawn_frames, exactness_far_away, wider_arrangements)
