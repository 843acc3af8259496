# SPDX-License-Identifier: MIT
"""Tables of the studies with their own runs: grid sizes, peers, crossovers, transfers, loops."""
from paper.numbers.crossovers import crossovers_by_kind
from paper.numbers.ratios import LEGEND, texts
from paper.numbers.transfers import hidden, overlaps
from paper.records import Missing
from paper.records import peers as measured_peers
from paper.tables.tabular import Table
from paper.text import APIS, cached, interval, ms

DEVICES = ("cuda", "opengl")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid"}
ORDERS = {"warm": "cell", "cold": "random"}
GRID_SIZES = ("A collision step through the grid, by the order of the spheres and the packing fraction: medians with their "
              "intervals, and the 95th percentiles of all rounds. †: the working set fits in the L2 cache. " + LEGEND)
PEERS = ("Milliseconds from centres on the GPU, in random order and of the packing fraction below, to the number of"
         " colliding pairs, or to the output that a system offers: ours and other systems on the same "
         "centres. The others were timed in a separate run, on an H200, as medians without "
         "intervals; wrong pairs are those of the last column. Ours run back to back, up to $10^6$ spheres overlapping.")
CROSSOVERS = ("The least $n$ up to {most:,} from which the grid stays faster than all pairs, per"
              " kind of spheres; and the greatest ratio of the automatic choice's time to the best fixed choice's (auto),"
              " 1 if the two are undecided or the same. Differences after Holm's correction over the sizes of a kind.")
TRANSFERS = ("CUDA steps, OpenGL draws {draw}: a frame with its transfer, a step, and both in a loop that waits only for the "
             "transfer; hidden: what that loop saves of the sum of the two. Medians, in brackets the bounds from their "
             "intervals.")
LOOPS = ("A whole loop, the first 20 steps of a fall: move, collide through the grid, draw; and its frames per second. "
         "CUDA to GL: CUDA steps and OpenGL draws {draw}, by the fastest transfer, pipelined. " + LEGEND)


def ours(machine, name, sizes):
    cells = []
    for n, fraction in sizes:
        found = machine.select(**GRID, order="cold", backend=name, n=n, packing_fraction=fraction)
        cells.append(ms(found[0].median) if found else "-")
    return [f"this paper, {APIS[name]}", "count", *cells, "0"]


def size_text(n):
    """E.g. 10^6."""
    digits = str(n)
    return f"10^{len(digits) - 1}" if digits.strip("0") == "1" else f"{n:,}"


def peers(machine):
    record = measured_peers()
    sizes = [tuple(size) for size in record["sizes"]]
    rows = [ours(machine, name, sizes) for name in DEVICES if machine.has(name)]
    if all(cell == "-" for row in rows for cell in row[2:-1]):
        raise Missing(f"{machine.name} has no record of the grid at the sizes that peers were timed at")
    for peer in record["peers"]:
        rows.append([peer["name"], peer["output"], *(ms(value) for value in peer["ms"]),
                     "-" if peer["wrong"] is None else str(peer["wrong"])])
    counted = [n for n, _ in sizes]
    groups = [(size_text(n), counted.count(n)) for n in dict.fromkeys(counted)]
    heads = [[("", 2), *groups, ("wrong", 1)], ["system", "output", *(f"{f:g}" for _, f in sizes), "pairs"]]
    mine = [row.source for row in machine.need(**GRID, order="cold") if row.backend in DEVICES and (row.n, row.scene["packing_fraction"]) in sizes]
    return Table("peers", PEERS, heads, rows, left=2, source=", ".join(dict.fromkeys([*mine, record["id"]])))


def crossover(machine):
    found = crossovers_by_kind(machine)
    names = [name for name in ("cpu", "opengl", "cuda") if any(name in by_backend for by_backend in found.values())]
    rows = []
    for kind, by_backend in found.items():
        row = [kind]
        for name in names:
            result = by_backend.get(name)
            row += ["-", "-"] if result is None else [result.start, result.loss]
        rows.append(row)
    heads = [[("", 1), *((APIS[name], 2) for name in names)], ["spheres", *["grid from", "auto"] * len(names)]]
    most = max(row.n for row in machine.need(table="crossover"))
    return Table("crossover", CROSSOVERS.format(most=most), heads, rows, source=next(iter(by_backend.values())).source)


def grid_sizes(machine):
    rows, pairs, sources = [], [], []
    for fraction, order in ((fraction, order) for fraction in (0.3, 0.05) for order in ORDERS):
        wanted = {**GRID, "packing_fraction": fraction, "order": order}
        for n in sorted({row.n for name in DEVICES for row in machine.select(**wanted, backend=name)}):
            glsl, cuda = (machine.select(**wanted, n=n, backend=name) for name in ("opengl", "cuda"))
            found = [of[0] for of in (glsl, cuda) if of]
            cells = [cell for of in (glsl, cuda) for cell in ((interval(of[0]), ms(of[0].p95_ms)) if of else ("-", "-"))]
            rows.append([ORDERS[order], f"{fraction:g}", cached(size_text(n), found), *cells])
            pairs.append((glsl[0], cuda[0]) if glsl and cuda else None)
            sources += [row.source for row in found]
    if not rows:
        raise Missing(f"{machine.name} has no grid on a GPU")
    rows = [[*row, text] for row, text in zip(rows, texts(pairs))]
    heads = [[("", 3), ("OpenGL, ms", 2), ("CUDA, ms", 2), ("", 1)],
             ["order", "fraction", "spheres", *["median [interval]", "p95"] * 2, "OpenGL/CUDA"]]
    return Table("grid-sizes", GRID_SIZES, heads, rows, source=", ".join(dict.fromkeys(sources)))


def transfer(machine):
    rows, root = [], overlaps(machine)
    for entry in root["overlaps"]:
        times = [entry[f"{what}_ms"] for what in ("frame", "step", "pipelined")]
        middle, least, most = hidden(root, entry)
        rows.append([entry["transfer"], size_text(entry["n"]), *map(ms, times),
                     f"{ms(middle)} [{ms(least)}, {ms(most)}]"])
    heads = [[("", 2), ("milliseconds", 4)], ["transfer", "spheres", "frame", "step", "both", "hidden"]]
    caption = TRANSFERS.format(draw=root["overlaps"][0]["draw"])
    return Table("transfer", caption, heads, rows, left=1, source=root["id"])


def loop(machine):
    transfers = overlaps(machine)
    rows, pairs, sources = [], [], [transfers["id"]]
    for place in ("outside", "inside"):
        for n in sorted({row.n for row in machine.need(table="draw", work="loop") if row.place == place}):
            glsl, cuda = (machine.select(table="draw", work="loop", place=place, n=n, backend=name)
                          for name in ("opengl", "cuda"))
            cells = [f"{interval(found[0])}" if found else "-" for found in (glsl, cuda)]
            rates = [f"{1e3 / found[0].median:,.0f}" if found else "-" for found in (glsl, cuda)]
            across = min((entry["pipelined_ms"] for entry in transfers["overlaps"] if entry["n"] == n), default=None)
            known = across is not None and place == "outside"
            rows.append([place, size_text(n), *cells, ms(across) if known else "-", *rates,
                         f"{1e3 / across:,.0f}" if known else "-"])
            pairs.append((glsl[0], cuda[0]) if glsl and cuda else None)
            sources += [found[0].source for found in (glsl, cuda) if found]
    heads = [[("", 2), ("median [interval], ms", 3), ("frames per second", 3), ("", 1)],
             ["camera", "spheres", *["OpenGL", "CUDA", "to GL"] * 2, "OpenGL/CUDA"]]
    rows = [[*row, text] for row, text in zip(rows, texts(pairs))]
    caption = LOOPS.format(draw=transfers["overlaps"][0]["draw"])
    return Table("loop", caption, heads, rows, left=1, source=", ".join(dict.fromkeys(sources)))


STUDIED = (grid_sizes, peers, crossover, transfer, loop)
