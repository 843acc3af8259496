# SPDX-License-Identifier: MIT
"""The main claims in one table: both APIs on the same work, with intervals, and the time ratio OpenGL/CUDA if these do not overlap."""
from paper.numbers.ranks import apart, ratio_text
from paper.records import Missing
from paper.tables.tabular import Table
from paper.text import cached, interval, ms

LARGEST = 2**20  # of all pairs
GAS = {"scene": "uniform", "packing_fraction": 0.3}
CAPTION = ("The main claims, in milliseconds: medians with their intervals, and the 95th percentiles of all rounds. OpenGL/CUDA: "
           "the time ratio with its bounds, if it is on one side of 1. CPU: median, all threads. †: the working set, which is not "
           "recorded for frames, fits in the L2 cache.")


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
    rows, sources = [], []
    for what, size, wanted, of_cpu in rows_wanted():
        glsl, cuda = (machine.select(backend=name, **wanted) for name in ("glsl", "cuda"))
        cpu = machine.select(backend="cpu", **{**wanted, **of_cpu})
        if len(glsl) > 1 or len(cuda) > 1:
            raise Missing(f"{machine.name} has several records of: {what}, {size}")
        if not (glsl and cuda):
            continue
        cells = [cell for row in (glsl[0], cuda[0]) for cell in (interval(row), ms(row.p95_ms))]
        rows.append([what, cached(size, (glsl[0], cuda[0])), ratio_text(glsl[0], cuda[0], apart), *cells,
                     ms(cpu[0].median) if len(cpu) == 1 else "-"])
        sources += [row.source for row in (glsl[0], cuda[0], *(cpu if len(cpu) == 1 else ()))]
    if not rows:
        raise Missing(f"{machine.name} has no work that both APIs did")
    heads = [[("", 3), ("OpenGL", 2), ("CUDA", 2), ("", 1)],
             ["work", "spheres", "OpenGL/CUDA", *["median [interval]", "p95"] * 2, "CPU"]]
    return Table("claims", CAPTION, heads, rows, left=1, source=", ".join(dict.fromkeys(sources)))
