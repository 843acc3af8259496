# SPDX-License-Identifier: MIT
"""Numbers of the prose that set things beside each other: peers, kinds of spheres, skips, hand-overs."""
from crossovers import crossovers_by_kind
from derived import ratio
from records import Missing, peers
from skips import pairs_of
from tables_studies import overlaps
from tabular import ms

DEVICES = ("glsl", "cuda")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid", "order": "cold"}
CEILING = 10  # percent that auto may lose to the best fixed choice


def beside_peers(put, machine, others):
    """Ours against the fastest other that counts, and whether the pairs are the same."""
    record = peers()
    met = []
    for k, (n, fraction) in enumerate(record["sizes"]):
        mine = {name: machine.select(**GRID, backend=name, n=n, packing_fraction=fraction) for name in DEVICES}
        if not all(mine.values()):
            continue
        exact = record["exact_pairs"][k]
        if exact is not None and any(rows[0].pairs != exact for rows in mine.values()):
            raise Missing(f"{machine.name}: {n} spheres have other pairs than the peers' centres, which the text denies")
        others_ms = [peer["ms"][k] for peer in record["peers"] if peer["ms"][k] is not None]
        libraries = [peer["ms"][k] for peer in record["peers"] if peer["library"] and peer["ms"][k] is not None]
        if mine["cuda"][0].high >= min(others_ms) or mine["glsl"][0].high >= min(libraries):
            raise Missing(f"{machine.name}: a peer is as fast at {n} spheres, packing fraction {fraction}")
        met.append((n, fraction, mine, min(others_ms), min(libraries)))
    if not met:
        raise Missing(f"{machine.name} has no record of the grid at the sizes that peers were timed at")
    n, fraction, mine, fastest, library = met[-1]
    put("peers/sizes", str(len(met)), record["id"], "sizes and fractions at which ours and the peers were timed")
    put("peers/n", f"{n:,}", record["id"], "most spheres of those")
    put("peers/fraction", f"{fraction:g}", record["id"], "packing fraction of those")
    put("peers/fastest", ms(fastest), record["id"], "ms, the fastest other there")
    put("peers/library", ms(library), record["id"], "ms, the fastest library there")
    put("peers/wrong", str(max(peer["wrong"] or 0 for peer in record["peers"])), record["id"], "most wrong pairs")
    for name in DEVICES:
        put(f"peers/ours/{name}", ms(mine[name][0].median), mine[name][0].source, f"{mine[name][0].label}, n = {n}, cold")


def kinds_of_spheres(put, machine, others):
    found = crossovers_by_kind(machine)
    worst = max((result.worst, kind, name) for kind, by_backend in found.items() for name, result in by_backend.items()
                if name in DEVICES)
    source = next(iter(found["gas"].values())).source
    if worst[0] > CEILING:
        raise Missing(f"{machine.name}: auto loses {worst[0]:.0f} %, more than the text allows")
    put("kinds/all", str(len(found)), source, "kinds of spheres in which auto was timed")
    put("kinds/worst", f"{worst[0]:.0f}", source, f"% by which auto was slower at worst: {worst[1]}, {worst[2]}")
    for kind, by_backend in found.items():
        for name in by_backend.keys() & set(DEVICES):
            put(f"kinds/{kind}/{name}", by_backend[name].start, source, f"{name}, {kind}: least n of the grid's lead")


def what_skips_save(put, machine, others):
    """For each option, backend and size: the factor, as `skip/NAME/BACKEND` at the largest size and /SIZE at others."""
    pairs = pairs_of(machine)
    put("skips/all", str(len({on.skip for on, _ in pairs})), pairs[0][0].source, "options timed on and off")
    largest = {}
    for on, off in pairs:
        middle, below, _ = ratio(off, on)
        key = f"skip/{on.skip}/{on.backend}"
        what = f"{on.skip} off over on, {on.backend}, n = {on.n}, {on.scene['name']}"
        put(f"{key}/{on.n}/{on.scene['name']}", factor(middle), on.source, what)
        if on.n >= largest.get(key, (0,))[0]:
            largest[key] = (on.n, middle, on.source, what)
    for key, (_, middle, source, what) in largest.items():
        put(key, factor(middle), source, what)


def factor(value):
    return f"{value:.2f}" if value < 3 else f"{value:.1f}" if value < 20 else f"{value:.0f}"


def pipelined_hand_overs(put, machine, others):
    root = overlaps(machine)
    most = max(entry["n"] for entry in root["overlaps"])
    rows = [entry for entry in root["overlaps"] if entry["n"] == most]
    for key, row in (("best", max(rows, key=lambda entry: entry["overlap"])),
                     ("fastest", min(rows, key=lambda entry: entry["pipelined_ms"]))):
        what = f"{row['hand_over']}, {row['draw']}, n = {most}"
        put(f"overlap/{key}", f"{100 * row['overlap']:.0f}", root["id"], f"% of the shorter hidden, {what}")
        put(f"overlap/{key}/ms", ms(row["pipelined_ms"]), root["id"], f"ms, pipelined picture and step, {what}")
        put(f"overlap/{key}/way", row["hand_over"], root["id"], what)


COMPARED = (beside_peers, kinds_of_spheres, what_skips_save, pipelined_hand_overs)
