# SPDX-License-Identifier: MIT
"""How each number of the prose is made from recorded runs. A maker puts (key, text, run, how) for one section."""
from derived import best, cost, issue_rate, matched, pairs_of, share_of_floor, slope
from ranks import apart, differ
from records import Missing, original_paper
from tabular import ms

PRINTED = "original paper"
SIZE = 16384
DEVICES = ("glsl", "cuda")


def original(put, machine, others):
    paper, last = original_paper(), original_paper()["table1"][-1]
    put("original/parallel", f"{last[6]}", PRINTED, "Table 1, parallel sphere-sphere, every row")
    put("original/sequential", f"{last[5]:,}", PRINTED, "Table 1, sequential sphere-sphere, last row")
    put("original/plane", f"{last[4]}", PRINTED, "Table 1, sequential sphere-plane, last row")
    put("original/drawing", f"{last[2]}", PRINTED, "Table 1, sequential rendering, last row")
    put("original/fps", f"{last[1]}", PRINTED, "Table 1, fps, last row")
    frame = last[2] + last[4] + last[5]
    put("original/frame", f"{frame:,}", PRINTED, "Table 1, last row: the three sequential times added")
    put("original/frame-fps", f"{1000 / frame:.2f}", PRINTED, "1000 / the sum of the parts of the last row")
    put("original/largest", f"{paper['text']['largest n ms']}", PRINTED, "text, time at 32,768 spheres")
    put("original/at512/table", f"{paper['table1'][3][5]}", PRINTED, "Table 1, sequential sphere-sphere, 512 spheres")
    put("original/at512/text", f"{paper['text']['pairs sequential at 512 ms']}", PRINTED, "text, sequential, 512")
    put("original/three-ticks", f"{3 * 1000 / 64:.1f}", "arithmetic", "3 ticks of a clock of 64 ticks a second")
    put("original/three-refreshes", f"{3 * 1000 / 60:.0f}", "arithmetic", "3 refreshes of a 60 Hz display")


def whole_steps(put, machine, others):
    for name in ("cpu", *DEVICES):
        record = machine.one(table="step", backend=name, n=SIZE)
        put(f"step/{name}", ms(record.median), record.source, f"median, whole step, n = {SIZE}, {record.label}")
        smallest = machine.need(table="step", backend=name)[0]
        put(f"step/smallest/{name}", ms(smallest.median), smallest.source, f"{smallest.label}, n = {smallest.n}")
    cpu = {record.n: record for record in machine.need(table="step", backend="cpu")}
    for name in DEVICES:
        rows = machine.need(table="step", backend=name)
        ahead = [r for r in rows if differ(r, cpu[r.n]) and r.median < cpu[r.n].median]
        put(f"step/ahead-of-cpu/{name}", f"{ahead[0].n:,}", ahead[0].source,
            f"least n where {name}'s whole step is faster than the CPU's")
    put("cpu/threads", str(machine.main["context"]["machine"]["hardware_threads"]), machine.id, "hardware threads")


def pairs_alone(put, machine, others):
    for method, key in (("sequential", "one"), ("parallel", "all")):
        record = machine.one(table="table1", backend="cpu", method=method, n=SIZE)
        put(f"pairs/cpu/{key}", ms(record.median), record.source, f"median, pairs, n = {SIZE}, {record.label}")
    for name in DEVICES:
        for method in ("tiled", "triangle"):
            record = machine.one(table="table1", backend=name, method=f"collide_{method}", n=SIZE)
            put(f"pairs/{name}/{method}", ms(record.median), record.source, f"median, n = {SIZE}, {record.label}")


def who_leads(put, machine, others):
    contests = [pair for wanted in ({"table": "scale", "scene": "random"}, {"table": "scale", "scene": "uniform"},
                                    {"table": "step"}) for pair in matched(machine, **wanted)]
    wins = {"cuda": [], "glsl": []}
    for glsl, cuda in contests:
        if apart(glsl, cuda):
            winner, loser = ("glsl", cuda) if glsl.median < cuda.median else ("cuda", glsl)
            wins[winner].append((100 * (1 - min(glsl.median, cuda.median) / loser.median), glsl.n))
    if not wins["cuda"] or not wins["glsl"] or max(n for _, n in wins["cuda"]) >= min(n for _, n in wins["glsl"]):
        raise Missing(f"{machine.name}: CUDA does not lead below and GLSL above one number of spheres")
    for name, found in wins.items():
        how = f"whole steps and all pairs where {name} is faster and the intervals are apart"
        put(f"lead/{name}/least", f"{min(found)[0]:.0f}", machine.id, f"least lead in %, {how}")
        put(f"lead/{name}/most", f"{max(found)[0]:.0f}", machine.id, f"greatest lead in %, {how}")
    put("lead/cuda/last", f"{max(n for _, n in wins['cuda']):,}", machine.id, "largest n of those")
    put("lead/glsl/first", f"{min(n for _, n in wins['glsl']):,}", machine.id, "smallest n of those")
    between = sorted({glsl.n for glsl, cuda in contests if not apart(glsl, cuda)})
    if not between:
        raise Missing(f"{machine.name}: no intervals overlap, though the text says where they do")
    put("lead/open", ", ".join(f"{n:,}" for n in between), machine.id, "n where the intervals overlap")
    put("lead/contests", str(len(contests)), machine.id, "sizes and scenes where both were timed")


def floors(put, machine, others):
    put("floor/rate", f"{issue_rate(machine) / 1e12:.1f}", machine.id, "10^12/s: multiprocessors x 128 x highest clock")
    for scene in ("random", "uniform"):
        for name in DEVICES:
            rows = machine.need(table="scale", scene=scene, backend=name)
            last, pairs = rows[-1], 0.5 * rows[-1].n * (rows[-1].n - 1)
            what = f"{last.label}, n = {last.n}, {scene}"
            put(f"floor/{scene}/{name}", f"{share_of_floor(machine, last):.0f}", last.source, f"in %, {what}")
            put(f"rate/{scene}/{name}", f"{pairs / last.median / 1e9:.2f}", last.source, f"10^12/s, {what}")
            put(f"slope/{scene}/{name}", f"{slope(rows[-2], last):.2f}", last.source, f"n = {rows[-2].n} to {last.n}")


def exactness(put, machine, others):
    costs = {(e.backend, e.method): (cost(n, e)[0], 1e3 * (e.median - n.median), e, n) for e, n in pairs_of(machine)}
    for (name, method), (percent, micro, exact, naive) in costs.items():
        if name == "cpu" and method != "collide_grid" and differ(exact, naive):
            raise Missing("exactness makes a difference to all pairs on the CPU, which the text denies")
        if name != "cpu":
            short = method.removeprefix("collide_")
            put(f"exact/{name}/{short}", f"{percent:.1f}", exact.source, f"cost in %, {exact.label}, n = {exact.n}")
            put(f"exact/us/{name}/{short}", f"{micro:.1f}", exact.source, f"cost in microseconds, {exact.label}")
    row = machine.main["tables"]["exactness"][0]["rows"][0]
    for key, cell in zip(("right", "missed", "added"), row[6:9]):
        put(f"grazing/{key}", f"{int(cell):,}", machine.id, f"grazing scene, {key}")


def launches(put, machine, others):
    one = {name: machine.one(table="overhead", backend=name, launches_per_step=1).median for name in DEVICES}
    if 2 * one["cuda"] >= one["glsl"]:
        raise Missing(f"{machine.name}: CUDA's round trip costs half of GLSL's or more, which the text denies")
    for name in DEVICES:
        rows = {r.launches_per_step: r for r in machine.need(table="overhead", backend=name)}
        for count, key in ((1, "one"), (1000, "many")):
            put(f"launch/{key}/{name}", f"{1e3 * rows[count].median / count:.1f}", rows[count].source,
                f"microseconds a launch, {name}, {count} between two waits")


def first_uses(put, machine, others):
    for name in DEVICES:
        record = machine.one(table="methods", backend=name, method="collide_triangle", block=128)
        put(f"first/{name}", ms(record.first_step_ms), record.source, f"first use of {record.label} in the run, ms")


def arrangements(put, machine, others):
    for name in DEVICES:
        tiled, square, triangle = (best(machine, name, f"collide_{m}") for m in ("tiled", "square", "triangle"))
        put(f"gain/square/{name}", f"{tiled.median / square.median:.1f}", square.source, f"{name}, tiled/square")
        put(f"gain/triangle/{name}", f"{square.median / triangle.median:.1f}", square.source,
            f"{name}, square/triangle")
        for method in ("tiled", "triangle"):
            rows = machine.need(table="methods", backend=name, method=f"collide_{method}")
            worst = max(rows, key=lambda record: record.median)
            least = min(rows, key=lambda record: record.median)
            put(f"groups/{method}/{name}", f"{worst.median / least.median:.2f}", worst.source,
                f"{name}, slowest group size ({worst.block}) over fastest ({least.block}), {method}")
            put(f"groups/{method}/{name}/worst", f"{worst.block}", worst.source, f"{name}, slowest, {method}")


MEASURED = (original, whole_steps, pairs_alone, who_leads, floors, exactness, launches, first_uses, arrangements)
