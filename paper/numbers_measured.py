# SPDX-License-Identifier: MIT
"""How each number of the prose is made from recorded runs. A maker puts (key, text, run, how) for one section."""
from derived import best, cost, crossover, issue_rate, matched, pairs_of, share_of_floor, slope
from pareto import paper_setting, seconds
from ranks import apart, differ
from records import Missing, original_paper
from tables import ms

PRINTED = "original paper"
SIZE = 16384
DEVICES = ("glsl", "cuda")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid"}


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


def grid(put, machine, others):
    largest = max(glsl.n for glsl, _ in matched(machine, **GRID, packing_fraction=0.3, order="cold"))
    put("grid/largest", f"{largest:,}", machine.need(**GRID)[0].source, "largest n of the grid in both APIs, cold")
    least = machine.need(table="grid", scene="uniform", packing_fraction=0.3, method="collide_triangle")[0]
    put("grid/smallest", f"{least.n:,}", least.source, "least n at which the grid and all pairs were timed")
    for name in DEVICES:
        wanted = {"table": "grid", "scene": "uniform", "packing_fraction": 0.3, "backend": name}
        start = crossover(machine, name, 0.3)
        if start is None:
            raise Missing(f"{machine.name}: the grid is not faster than all pairs at large n on {name}")
        first = machine.one(**wanted, method="collide_grid", order="cold", n=start)
        put(f"grid/from/{name}", f"{start:,}", first.source, f"{name}, least n from which the grid is faster, cold")
        for order in ("cold", "warm"):
            last = machine.one(**wanted, method="collide_grid", order=order, n=largest)
            put(f"grid/{order}/{name}", ms(last.median), last.source, f"{last.label}, n = {last.n}, {order}")
            if "share_of_floor" in last.parameters:
                put(f"grid/floor/{name}/{order}", f"{100 * last.share_of_floor:.0f}", last.source,
                    f"{last.label}, share of the floor in %, n = {last.n}, {order}")


def grid_leads(put, machine, others):
    """CUDA's lead in the grid, over every order and packing fraction."""
    contests = [pair for order in ("cold", "warm") for fraction in fractions(machine)
                for pair in matched(machine, **GRID, packing_fraction=fraction, order=order)]
    if not all(apart(*pair) and pair[1].median < pair[0].median for pair in contests):
        raise Missing(f"{machine.name}: CUDA's grid is not the faster throughout, which the text says")
    leads = sorted(((100 * (1 - cuda.median / glsl.median), cuda) for glsl, cuda in contests), key=lambda lead: lead[0])
    put("grid/contests", str(len(contests)), contests[0][0].source, "sizes, orders and fractions of the grid in both")
    for key, (lead, row) in (("most", leads[-1]), ("least", leads[0])):
        put(f"grid/lead/{key}", f"{lead:.0f}", row.source, f"{key} lead of CUDA in %: n = {row.n}, {row.order}, "
            f"packing fraction {row.scene['packing_fraction']:g}")


def fractions(machine):
    return sorted({row.scene["packing_fraction"] for row in machine.need(**GRID)})


def errors_of_motion(put, machine, others):
    """The original's method beside anchored flights: alone, and with the position evaluated in every step."""
    for name in DEVICES:
        rows = machine.need(table="precision", backend=name)
        paper, = paper_setting(rows)
        anchored = {(row.precision, row.work, row.dt): row for row in rows if row.method == "anchored"}
        same, longest = paper.dt, max(row.dt for row in rows)
        for key, row in (("paper", paper), ("anchored", anchored["float32", "move", same]),
                         ("placed", anchored["float32", "move and place", same]),
                         ("longer", anchored["float32", "move and place", longest]),
                         ("exact", anchored["float64", "move", same])):
            if key in ("anchored", "longer") and not (seconds(row) < seconds(paper) and row.error_m < paper.error_m):
                raise Missing(f"{name}: {row.label} is not both faster and more accurate, which the text says")
            what = f"{row.method}, {row.precision}, {row.work}, step {row.dt:g} s"
            put(f"motion/{key}/ns/{name}", f"{seconds(row):.2f}", row.source, f"ns a sphere and second, {name}, {what}")
            put(f"motion/{key}/error/{name}", scientific(row.error_m), row.source, f"rms error in m, {name}, {what}")


def scientific(value):
    """In mathematics where a decimal would be long."""
    if value >= 0.01:
        return f"{value:.2f}"
    digits, exponent = f"{value:.1e}".split("e")
    return f"${digits} \\cdot 10^{{{int(exponent)}}}$"


def pictures(put, machine, others):
    rows = {name: machine.need(table="draw", work="frame", place="outside", backend=name) for name in DEVICES}
    both = max({row.n for row in rows["glsl"]} & {row.n for row in rows["cuda"]})
    put("draw/both", f"{both:,}", rows["cuda"][0].source, "most spheres drawn through both APIs")
    for name in DEVICES:
        for n, key in ((both, "both"), (rows[name][-1].n, "most")):
            best_way = min((row for row in rows[name] if row.n == n), key=lambda row: row.median)
            put(f"draw/{key}/{name}", ms(best_way.median), best_way.source, f"{best_way.label}, n = {n}")
            put(f"draw/{key}/{name}/n", f"{n:,}", best_way.source, f"{name}, spheres drawn from outside")
            put(f"draw/{key}/{name}/way", best_way.draw, best_way.source, f"{name}, fastest way to draw {n} spheres")


def hand_overs(put, machine, others):
    rows = machine.need(table="interop")
    rows = sorted((row for row in rows if row.n == rows[-1].n), key=lambda row: row.median)
    put("interop/n", f"{rows[0].n:,}", rows[0].source, "most spheres handed over")
    for key, row in (("fast", rows[0]), ("slow", rows[-1])):
        put(f"interop/{key}", ms(row.median), row.source, f"ms, {row.way}, n = {row.n}")
        put(f"interop/{key}/way", row.way, row.source, f"the {key}est way to hand over, n = {row.n}")


MEASURED = (original, whole_steps, pairs_alone, who_leads, floors, exactness, launches, first_uses, arrangements,
            grid, grid_leads, errors_of_motion, pictures, hand_overs)
