# SPDX-License-Identifier: MIT
"""Measured times of the prose. Each function puts (key, text, run, description) for one section."""
from paper.numbers.derived import issue_rate, pairs_of, share_of_floor, slope
from paper.numbers.ratios import extent, family
from paper.records import original_paper, said, steady
from paper.text import ms

PRINTED = "original paper"
SIZE = 16384
DEVICES = ("opengl", "cuda")


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
    pair = [machine.one(table="step", backend=name, n=SIZE) for name in DEVICES]
    put("step/extent", extent(family([pair])), pair[0].source, "what the comparison of these steps stands on")
    for name in DEVICES:
        rows = [row for row in machine.need(table="step", backend=name) if steady(row, cpu[row.n])]
        compared = family([(row, cpu[row.n]) for row in rows])
        behind = [row.n for row, ratio in zip(rows, compared) if not (ratio.decided and ratio.middle < 1)]
        ahead = [row for row in rows if row.n > max(behind, default=0)]
        said(machine, behind and ahead and ahead[0].n <= 4096, "the CPU is faster only for a few hundred spheres")
        put(f"step/ahead-of-cpu/{name}", f"{ahead[0].n:,}", ahead[0].source,
            f"least n from which on {name}'s whole step is faster than the CPU's")
    put("cpu/threads", str(machine.threads), machine.id, "threads of the CPU")


def frame_rates(put, machine, others):
    def frames(name, n):
        return machine.one(table="frame_rates", work="frame", label=f"{name} frame", n=n)

    for name in ("sequential", *DEVICES):
        for key, n in (("smallest", 64), ("large", SIZE)):
            record = frames(name, n)
            rate = 1e3 / record.median
            put(f"fps/{name}/{key}", f"{rate:,.0f}" if rate >= 10 else f"{rate:.1f}", record.source,
                f"1000 / median, whole frame, n = {n}, {record.label}")
    small, large = ([frames(name, n).median for name in DEVICES] for n in (64, SIZE))
    said(machine, small[1] > 2 * small[0] and large[1] < 1.1 * large[0],
         "CUDA's frames cost the transfer to OpenGL, which shows where spheres are few")
    put("fps/ahead", f"{small[0] / small[1]:.2f}x", frames("opengl", 64).source, "time ratio GLSL/CUDA of a frame, n = 64")

    def drawing(label):
        return machine.one(table="frame_rates", work="draw", label=label, n=SIZE)

    quadric, mesh, once = map(drawing, ("sequential quadric", "sequential mesh_each", "opengl mesh"))
    put("fps/quadric", f"{quadric.median / mesh.median:.1f}", mesh.source, f"{quadric.label} / {mesh.label}, n = {SIZE}")
    said(machine, once.median < mesh.median, "one instanced draw takes less than one draw a sphere")
    put("fps/instanced", f"{100 * (1 - once.median / mesh.median):.0f}", mesh.source,
        f"in %, less time: {once.label} than {mesh.label}, n = {SIZE}")


def arrangements(put, machine, others):
    found = {(r.backend, r.scene["groups"], r.scene["group_size"], r.block): r
             for r in machine.need(table="arrangements")}
    percent = {name: [] for name in ("small", "large")}
    for (name, m, n, block), record in found.items():
        if block == n:
            percent["small" if n < 32 else "large"].append(100 * (record.median / found[name, m, n, m * n].median - 1))
    source = next(iter(found.values())).source
    said(machine, max(map(abs, percent["large"])) < 10 and max(percent["small"]) > 10,
         "arrangements take similar times in groups of 32 and more, not in smaller ones")
    put("arranged/large", f"{max(map(abs, percent['large'])):.0f}", source,
        "in %, greatest difference to one group of all, groups of 32 or 64")
    put("arranged/small", f"{max(percent['small']):.0f}", source, "in %, the same, groups of 8 or 16")


def pairs_alone(put, machine, others):
    for method, key in (("sequential", "one"), ("parallel", "all")):
        record = machine.one(table="table1", backend="cpu", method=method, n=SIZE)
        put(f"pairs/cpu/{key}", ms(record.median), record.source, f"median, pairs, n = {SIZE}, {record.label}")
        for end, value in (("low", record.low), ("high", record.high)):
            put(f"pairs/cpu/{key}/{end}", ms(value), record.source, f"its interval, {end} end")
    later = machine.one(table="exactness", backend="cpu", method="sequential", n=SIZE, exact=True)
    put("pairs/cpu/one/later", ms(later.median), later.source, f"median, pairs, n = {SIZE}, {later.label}, table exactness")
    for name in DEVICES:
        for method in ("tiled", "triangle"):
            record = machine.one(table="table1", backend=name, method=f"collide_{method}", n=SIZE)
            put(f"pairs/{name}/{method}", ms(record.median), record.source, f"median, n = {SIZE}, {record.label}")


def floors(put, machine, others):
    put("floor/rate", f"{issue_rate(machine) / 1e12:.1f}", machine.id, "10^12/s: multiprocessors x 128 x highest clock")
    for scene in ("random", "uniform"):
        for name in DEVICES:
            rows = machine.need(table="scale", scene=scene, backend=name)
            last, pairs = rows[-1], 0.5 * rows[-1].n * (rows[-1].n - 1)
            what = f"{last.label}, n = {last.n}, {scene}"
            put(f"floor/{scene}/{name}", f"{share_of_floor(machine, last):.0f}", last.source, f"in %, {what}")
            put(f"rate/{scene}/{name}", f"{pairs / last.median / 1e9:.2f}", last.source, f"10^12/s, {what}")
            said(machine, 1.8 < slope(rows[-2], last) < 2.2, "the time of all pairs grows as the square at last")
            put(f"slope/{scene}/{name}", f"{slope(rows[-2], last):.2f}", last.source, f"n = {rows[-2].n} to {last.n}")


def exactness(put, machine, others):
    found = {(exact.backend, exact.method.removeprefix("collide_")): (exact, naive) for exact, naive in pairs_of(machine)}
    micro = {key: 1e3 * (exact.median - naive.median) for key, (exact, naive) in found.items()}
    compared = dict(zip(found, family(list(found.values()))))
    percent = {key: 100 * (ratio.middle - 1) for key, ratio in compared.items()}
    said(machine, all(micro[key] < 1 or percent[key] < 1 for key in micro if key[0] != "cpu"),
         "exactness costs a GPU's methods less than a microsecond or a percent if no pair is left undecided")
    source = found["cuda", "triangle"][0].source
    put("exact/most", f"{max(abs(value) for (name, _), value in percent.items() if name != 'cpu'):.1f}", source,
        "in %, the greatest difference of the medians, of a GPU's methods")
    for key, bound in (("bound", lambda method: True), ("bound/pairs", lambda method: method != "grid")):
        highest = max(100 * (ratio.high - 1) for (name, method), ratio in compared.items() if name != "cpu" and bound(method))
        put(f"exact/{key}", f"{highest:.1f}", source,
            f"in %, the highest upper end of the cost's interval, of a GPU's methods{' of all pairs' if key != 'bound' else ''}")
    said(machine, not any(ratio.decided and ratio.middle > 1 for (name, _), ratio in compared.items() if name != "cpu"),
         "no cost of exactness is decided on a GPU if no pair is left undecided")
    of_cpu = {method: ratio for (name, method), ratio in compared.items() if name == "cpu"}
    seen = [f"{percent['cpu', method]:.0f}\\,\\% for \\kernel{{{method}}}" for method, ratio in of_cpu.items() if ratio.decided]
    low, high = min(100 * (ratio.low - 1) for ratio in of_cpu.values()), max(100 * (ratio.high - 1) for ratio in of_cpu.values())
    undecided = f"its cost is undecided: the intervals reach from ${low:.0f}$ to ${high:+.0f}$\\,\\%"
    put("exact/cpu", f"it costs {' and '.join(seen)}" if seen else undecided, source, "sentence: the CPU's cost")
    row = machine.main["tables"]["exactness"][-1]["rows"][0]  # older records have one table of times and pairs
    for key, cell in zip(("right", "missed", "added"), row[-3:]):
        put(f"grazing/{key}", f"{int(cell):,}", machine.id, f"grazing scene, {key}")


MEASURED = (original, whole_steps, frame_rates, arrangements, pairs_alone, floors, exactness)
