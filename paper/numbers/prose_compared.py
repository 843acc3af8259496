# SPDX-License-Identifier: MIT
"""Numbers of the prose about comparisons: peers, kinds of spheres, ablations, transfers."""
from paper.numbers.ablations import pairs_of
from paper.numbers.crossovers import crossovers_by_kind
from paper.numbers.derived import ratio
from paper.numbers.transfers import MOST_TRANSFERRED, hidden, overlaps
from paper.records import Missing, peers, said
from paper.text import ms

DEVICES = ("opengl", "cuda")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid", "order": "cold"}
NEVER = float("inf")
GOOD = 1.2  # auto's time over the best fixed choice's
FEW = 2048  # spheres for which small groups are faster
SAID = (("counts_read", "opengl", 1), ("counts_read", "cuda", 1), ("vector_loads", "opengl", 1), ("vector_loads", "cuda", 1),
        ("batch", "opengl", 1), ("plane_test", "opengl", 1), ("plane_test", "cuda", 1), ("exact_stages", "opengl", 1),
        ("exact_stages", "cuda", 1), ("order", "opengl", 1), ("order", "cuda", 1), ("cells", "opengl", 1), ("cells", "cuda", 1),
        ("read_back", "opengl", 1), ("read_back", "cuda", 1), ("own_clear", "opengl", 1), ("own_clear", "cuda", 1),
        ("overlap", "opengl", 1), ("overlap", "cuda", 1),
        ("own_buckets", "cuda", 1), ("texture_table", "opengl", 1), ("radius_load", "opengl", 1), ("radius_load", "cuda", 1),
        ("new_cells", "opengl", -1), ("new_cells", "cuda", -1))  # at the most spheres: saves (1), costs (-1), no difference seen (0)
WORTH = {1: "saves", 0: "makes no difference", -1: "costs"}


def against_peers(put, machine, others):
    """Ours and the fastest peer, and whether the pairs are the same."""
    record = peers()
    timed = []
    for k, (n, fraction) in enumerate(record["sizes"]):
        mine = {name: machine.select(**GRID, backend=name, n=n, packing_fraction=fraction) for name in DEVICES}
        if not all(mine.values()):
            continue
        exact = record["exact_pairs"][k]
        if exact is not None and any(rows[0].pairs != exact for rows in mine.values()):
            raise Missing(f"{machine.name}: {n} spheres have other pairs than the peers' centres, which contradicts the text")
        others_ms = [peer["ms"][k] for peer in record["peers"] if peer["ms"][k] is not None]
        libraries = [peer["ms"][k] for peer in record["peers"] if peer["library"] and peer["ms"][k] is not None]
        said(machine, mine["cuda"][0].high < min(others_ms) and mine["opengl"][0].high < min(libraries),
             f"CUDA is faster than every peer and GLSL than every library at {n} spheres, packing fraction {fraction}")
        timed.append((n, fraction, mine, min(others_ms), min(libraries)))
    if not timed:
        raise Missing(f"{machine.name} has no record of the grid at the sizes that peers were timed at")
    n, fraction, mine, fastest, library = timed[-1]
    put("peers/sizes", str(len(timed)), record["id"], "sizes and fractions at which ours and the peers were timed")
    put("peers/n", f"{n:,}", record["id"], "most spheres of those")
    put("peers/fraction", f"{fraction:g}", record["id"], "packing fraction of those")
    put("peers/fastest", ms(fastest), record["id"], "ms, the fastest other there")
    put("peers/library", ms(library), record["id"], "ms, the fastest library there")
    counts = {row.pairs for rows in mine.values() for row in rows}
    said(machine, len(counts) == 1, "both APIs find the same number of pairs at the peers' largest size")
    put("peers/wrong", str(max(peer["wrong"] or 0 for peer in record["peers"])), record["id"], "most wrong pairs, against the exact count")
    put("peers/pairs", f"{counts.pop():,}", mine["cuda"][0].source, f"exact pairs there, n = {n}, which both APIs found")
    for name in DEVICES:
        row, = mine[name]
        put(f"peers/ours/{name}", ms(row.median), row.source, f"{row.label}, n = {n}, cold")


def as_number(start):
    return NEVER if start == "nowhere" else int(start.replace(",", ""))


def groups_of_few(put, machine, others):
    for name in DEVICES:
        narrow, usual = (machine.one(table="crossover", backend=name, kind="gas", n=FEW, way=f"collide_square/{block}")
                         for block in (32, 128))
        said(machine, narrow.high < usual.low, f"{FEW} spheres are tested faster in groups of 32, {name}")
        for what, record in (("narrow", narrow), ("usual", usual)):
            put(f"few/{what}/{name}", ms(record.median), record.source, f"{record.label}, ms")
    put("few/n", f"{FEW:,}", narrow.source, "spheres of the comparison of group sizes")


def kinds_of_spheres(put, machine, others):
    found = crossovers_by_kind(machine)
    rows = [(loss, kind, name) for kind, by_backend in found.items() for name, result in by_backend.items()
            if name in DEVICES for loss in result.losses]
    worst, kind, name = max(rows)
    source = next(iter(found["gas"].values())).source
    put("kinds/all", str(len(found)), source, "kinds of spheres in which the grid, all pairs and auto were timed")
    put("kinds/rows", str(len(rows)), source, "kinds, sizes and APIs in which auto was timed")
    put("kinds/good", str(sum(loss <= GOOD for loss, _, _ in rows)), source, f"those in which it took at most {GOOD:g} times "
        "the best")
    put("kinds/cpu/worst", f"{max(max(by['cpu'].losses) for by in found.values()):.2g}", source,
        "greatest ratio of auto to the best fixed choice on the CPU")
    of_one_size = {}
    said(machine, worst <= GOOD, f"auto takes {GOOD:g} times the best fixed choice at most on the GPU (it is {worst:.2f}: {kind}, {name})")
    for name in DEVICES:
        start = {kind: as_number(by_backend[name].start) for kind, by_backend in found.items()}
        of_one_size[name] = [start[kind] for kind in ("gas", "thin", "box", "clusters")]
        said(machine, max(of_one_size[name]) < start["radii"] < start["one_cell"] == NEVER,
             f"the grid pays later with unequal radii than with equal ones, and never in one cell, in {name}")
    starts = sorted({n for found_starts in of_one_size.values() for n in found_starts})
    put("kinds/one-size", " or ".join(f"{n:,}" for n in (starts[0], starts[-1])[:len(starts)]), source,
        "least and greatest n from which the grid is faster, of the kinds with spheres of one size")
    for kind, by_backend in found.items():
        for name in by_backend.keys() & set(DEVICES):
            put(f"kinds/{kind}/{name}", by_backend[name].start, source, f"{name}, {kind}: least n from which the grid is faster")


def ablations(put, machine, others):
    """For each option, backend and size: the factor, as ablation/OPTION/BACKEND at the largest size, with /n at each."""
    factors = {(on.option, on.backend, on.n): (ratio(off, on), on.source) for on, off in pairs_of(machine)}
    for option, backend, sign in SAID:
        most = max(n for name, api, n in factors if (name, api) == (option, backend))
        (middle, below, above), _ = factors[option, backend, most]
        seen = 1 if middle - below > 1 else -1 if middle + above < 1 else 0
        said(machine, seen == sign, f"{option} on {backend} {WORTH[sign]} (it is {middle:.2f})")
    for name in DEVICES:
        most = max(n for _, api, n in factors if api == name)
        best = sorted((value[0][0], option) for (option, api, n), value in factors.items() if (api, n) == (name, most))[-2:]
        said(machine, [option for _, option in best] == ["exact_stages", "counts_read"],
             f"unrequested counts and the filter save most on {name} (it is {best})")
    source = next(iter(factors.values()))[1]
    for key, options in (("third", ("vector_loads", "plane_test")), ("fourth", ("cells", "order"))):
        spans = [value[0][0] for (option, _, n), value in factors.items() if option in options and n == most]
        put(f"ablation/{key}", f"{factor(min(spans))} to {factor(max(spans))}", source, f"time off over time on, {' and '.join(options)}, n = {most}")
    put("ablation/all", str(len({option for option, _, _ in factors})), source, "options timed on and off")
    for (option, backend, n), ((middle, _, _), source) in factors.items():
        largest = n == max(size for name, api, size in factors if (name, api) == (option, backend))
        for key in (f"ablation/{option}/{backend}/{n}", *([f"ablation/{option}/{backend}"] if largest else [])):
            put(key, factor(middle), source, f"{option}, {backend}, n = {n}: time off over time on")
            put(f"{key}/cost", factor(1 / middle), source, f"{option}, {backend}, n = {n}: time on over time off")


def factor(value):
    return f"{value:.2f}" if value < 1.5 else f"{value:.1f}" if value < 10 else f"{value:.0f}"


def hidden_text(middle, least, most):
    if least > 0:
        return f"{ms(middle)}\\,ms are hidden, with bounds from {ms(least)} to {ms(most)}\\,ms"
    return (f"{ms(-middle)}\\,ms are lost, with bounds from {ms(-most)} to {ms(-least)}\\,ms" if most < 0 else "no gain is seen")


def pipelined_transfers(put, machine, others):
    root = overlaps(machine)
    most = max(entry["n"] for entry in root["overlaps"] if entry["n"] <= MOST_TRANSFERRED)
    rows = {entry["transfer"]: entry for entry in root["overlaps"] if entry["n"] == most and entry["draw"] == "points"}
    put("overlap/n", f"{most:,}", root["id"], "spheres of the pipelined loop")
    for way, row in rows.items():
        put(f"overlap/{way}/frame", ms(row["frame_ms"]), root["id"], f"ms, frame, {way}, points, n = {most}")
        put(f"overlap/{way}", hidden_text(*hidden(root, row)), root["id"], f"words: time hidden, {way}, points, n = {most}")
    put("overlap/step", ms(row["step_ms"]), root["id"], f"ms, a step of that loop, n = {most}")
    drawn = [row for row in root["frames"] if (row["draw"], row["place"], row["n"]) == ("compute", "outside", most)]
    put("overlap/kernels", ms(drawn[0]["median_ms"]), root["id"], f"ms, CUDA's own frame in that run, n = {most}")


COMPARED = (against_peers, groups_of_few, kinds_of_spheres, ablations, pipelined_transfers)
