# SPDX-License-Identifier: MIT
"""The main claims in one table: both APIs on the same work, with intervals, and the time ratio OpenGL/CUDA."""
from paper.numbers.ratios import LEGEND, family
from paper.records import Missing
from paper.tables.tabular import Table
from paper.text import cached, interval, ms

LARGEST = 2**20  # of all pairs
GAS = {"scene": "uniform", "packing_fraction": 0.3}
CAPTION = ("The main claims, in milliseconds: medians with their intervals, and the 95th percentiles of all rounds. OpenGL/CUDA: "
           f"the time ratio; plain: by the plain means of the longest batches, without the fitted line. {LEGEND} Runs: processes on GPUs. "
           "CPU: median, all threads. †: the working set, which is not recorded for frames, fits in the L2 cache.")


def rows_wanted():
    """(what, its size, parameters of the records, other parameters of the CPU's)."""
    parallel = {"method": "parallel"}
    yield "a whole step, all pairs, original box", "16,384", {"table": "step", "n": 16384}, {}
    for n, text in ((16384, "16,384"), (LARGEST, "2^20")):
        yield "all pairs, original box", text, {"table": "scale", "scene": "random", "n": n}, parallel
        yield "all pairs, gas", text, {"table": "scale", "scene": "uniform", "n": n}, parallel
    for k in (6, 7, 8):
        for order, text in (("warm", "cell"), ("cold", "random")):
            yield (f"through the grid, {text} order", f"10^{k}",
                   {"table": "grid", **GAS, "method": "collide_grid", "order": order, "n": 10**k}, {})
    for method, text in (("paper", "the original's motion"), ("anchored", "anchored motion")):
        yield (text, "10^8",
               {"table": "precision", "precision": "float32", "method": method, "work": "move", "n": 10**8}, {})
    for k in (6, 7):
        yield ("a frame by the rasteriser", f"10^{k}",
               {"table": "draw", "draw": "compute", "work": "frame", "place": "outside", "n": 10**k}, {})
    yield "one launch and a wait", "-", {"table": "overhead", "launches_per_step": 1}, {}


def claims(machine):
    rows, pairs, sources = [], [], []
    for what, size, wanted, of_cpu in rows_wanted():
        glsl, cuda = (machine.select(backend=name, **wanted) for name in ("opengl", "cuda"))
        cpu = machine.select(backend="cpu", **{**wanted, **of_cpu})
        if len(glsl) > 1 or len(cuda) > 1:
            raise Missing(f"{machine.name} has several records of: {what}, {size}")
        if not (glsl and cuda):
            continue
        cells = [cell for row in (glsl[0], cuda[0]) for cell in (interval(row), ms(row.p95_ms))]
        rows.append([what, cached(size, (glsl[0], cuda[0])), *cells, ms(cpu[0].median) if len(cpu) == 1 else "-"])
        pairs.append((glsl[0], cuda[0]))
        sources += [row.source for row in (glsl[0], cuda[0], *(cpu if len(cpu) == 1 else ()))]
    if not rows:
        raise Missing(f"{machine.name} has no work that both APIs did")
    rows = [[work, size, ratio.text, f"{ratio.plain:.2f}" if ratio.plain else "-", f"{ratio.processes} on {max(1, len(ratio.gpus))}", *times]
            for (work, size, *times), ratio in zip(rows, family(pairs))]
    heads = [[("", 2), ("OpenGL/CUDA", 2), ("", 1), ("OpenGL", 2), ("CUDA", 2), ("", 1)],
             ["work", "spheres", "ratio [interval]", "plain", "runs", *["median [interval]", "p95"] * 2, "CPU"]]
    return Table("claims", CAPTION, heads, rows, left=1, source=", ".join(dict.fromkeys(sources)))
