# SPDX-License-Identifier: MIT
"""Numbers and sentences of the prose about leads: of an API, of many launches, of an arrangement."""
from paper.numbers import contests, leads
from paper.numbers.derived import best, matched
from paper.numbers.layers import layers
from paper.numbers.ratios import extent, family, time_ratio, values
from paper.records import Missing, said
from paper.text import ms

DEVICES = ("opengl", "cuda")
GROUP = 128
METHODS = ("group", "tiled", "square", "triangle")
COMPILED = 50  # ms that a first use takes only if the driver compiles


def who_leads(put, machine, others):
    found = leads.contests(machine)
    for key, text in (("wins", leads.wins(found)), ("headline", leads.headline(found)),
                      ("large", leads.at_large_sizes(found))):
        put(f"lead/{key}", text.replace(" %", "\\,\\%"), machine.id, f"sentence made from all contests: lead/{key}")
    put("lead/contests", str(len(found)), machine.id, "sizes and scenes in which both were timed, with whole steps")
    put("lead/extent", extent([entry.compared for entry in found]), machine.id, "what these contests stand on")
    table1 = leads.decided(matched(machine, table="table1", method="collide_triangle"))
    most = max((entry for entry in found + table1), key=lambda entry: entry.ratio)
    said(machine, most.ratio > 1, "at most, GLSL takes longer than CUDA")
    put("lead/most", f"{most.ratio:.2f}x", most.source,
        f"greatest time ratio GLSL/CUDA, {most.where or 'all pairs by triangle'}, n = {most.n}")
    said(machine, most.n <= contests.SHORT, "the greatest ratio is that of few spheres, where launches are the bound")
    large = [entry for entry in found if entry.n >= leads.LARGE]
    said(machine, all(0.85 <= entry.ratio <= 1.18 for entry in large), "at large sizes the APIs are within a few percent of each other for all pairs")
    put("lead/large/from", f"{leads.LARGE:,}", machine.id, "least n at which launches are negligible")
    put("lead/large/ratios", leads.ratios(large), machine.id, f"time ratios GLSL/CUDA from {leads.LARGE} on")


def short_steps(put, machine, others):
    """Whole steps of few spheres, where launches are most of the time."""
    found = contests.short_steps(machine)
    put("lead/short", contests.ratio_span(found), found[0].source, f"time ratios GLSL/CUDA of whole steps of up to {contests.SHORT} spheres")
    put("lead/short/most", f"{contests.SHORT:,}", found[0].source, "most spheres of a short step")


def all_contests(put, machine, others):
    """Counts by kind of work; ratios of unlike work are not pooled."""
    found = contests.contests(machine)
    runs = ", ".join(sorted({entry.source for entry in found}))
    for kind in ("", *contests.KINDS):
        own = [entry for entry in found if kind in ("", entry.work)]
        cuda, glsl = contests.decided(own)
        for key, number in (("all", len(own)), ("several", len(contests.several(own))), ("cuda", len(cuda)), ("opengl", len(glsl)),
                            ("open", len(own) - len(cuda) - len(glsl))):
            put("/".join(filter(None, ("contests", kind.replace(" ", "-"), key))), f"{number:,}", runs, f"contests of {kind or 'all kinds'}: {key}")
    for key, entry in zip(("least", "most"), contests.extremes(found)):
        put(f"contests/{key}", f"{entry.ratio.middle:.2f}x", entry.source, f"{key} ratio that is decided in several processes")
        put(f"contests/{key}/what", entry.what, entry.source, "its method and spheres")
        put(f"contests/{key}/n", f"{entry.n:,}", entry.source, "its number of spheres")


def plain_means(put, machine, others):
    found = contests.plain_means(contests.contests(machine))
    runs = machine.id
    put("plain/contests", f"{found.contests:,}", runs, "contests whose longest batches have plain means")
    put("plain/median", f"{found.percent:.1f}", runs, "%, median change of a ratio by plain means against fitted slopes")
    put("plain/most", f"{found.widest:.0f}", runs, "%, greatest change")
    put("plain/flips", str(found.flips), runs, "ratios that fall on the other side of 1")
    put("plain/flips/decided", str(found.decided_flips), runs, "decided ones among them")


def one_launch(put, machine, others):
    """Motion with the plane, one launch a step, of the first table."""
    pairs = matched(machine, table="table1", work="move")
    found = leads.decided(pairs)
    said(machine, not any(entry.winner for entry in found), "in motion neither API leads, at any size of the first table")
    for record in (record for pair in pairs[:1] for record in pair):
        medians = [process["median_ms"] for row in machine.need(table="table1", work="move", backend=record.backend)
                   for process in row.parameters.get("processes") or [{"median_ms": row.median}]]
        put(f"motion/small/{record.backend}", f"{1e3 * min(medians):.1f} to {1e3 * max(medians):.1f}", record.source,
            f"microseconds of a step of motion and plane in {record.backend}, of all sizes and processes")
    medians = [value for pair in pairs for value in values(*pair)]
    put("motion/small/ratios", f"{min(medians):.2f}x to {max(medians):.2f}x", found[0].source,
        "time ratios GLSL/CUDA of motion and plane, original table, of all sizes and processes")
    put("motion/small/sizes", str(len(found)), found[0].source, "sizes of motion and plane that both timed")


def methods(put, machine, others):
    """Of the four arrangements at one size."""
    pairs = [tuple(machine.one(table="methods", backend=name, method=f"collide_{method}", block=128)
                   for name in DEVICES) for method in METHODS]
    found = leads.decided(pairs)
    parts = [f"OpenGL takes {leads.ratios(mine)} CUDA's time in {len(mine)} of {len(found)}"
             for name in ("cuda", "opengl") if (mine := leads.won(found, name))]
    put("methods/leads", " and ".join(parts) or "no difference is decided", pairs[0][0].source,
        "sentence made from the four methods at groups of 128")


def repeats(put, machine, others):
    """What intervals within a process do not show: the GPU's row of whole steps in the table `variation`."""
    rows = [(layers(row), row) for name in DEVICES for row in machine.need(table="step", backend=name) if row.parameters.get("processes")]
    for key, layer in (("within", "within"), ("between", "processes")):
        widest, row = max(((found[layer], row) for found, row in rows if layer in found), key=lambda each: each[0], default=(0, None))
        if row is None:
            raise Missing(f"{machine.name} has no whole steps of several processes on one GPU")
        put(f"repeat/{key}", f"{widest:.1f}", row.source, f"%, widest spread of a whole step, {key}: {row.label}, n = {row.n}")


def launches(put, machine, others):
    rows = {name: {r.launches_per_step: r for r in machine.need(table="overhead", backend=name)} for name in DEVICES}
    one, many = ({name: rows[name][count].median / count for name in DEVICES} for count in (1, 1000))
    said(machine, one["cuda"] < one["opengl"], "a round trip costs less in CUDA")
    put("launch/one/ratio", f"{one['opengl'] / one['cuda']:.1f}x", rows["opengl"][1].source, "time ratio OpenGL/CUDA of a round trip")
    cheaper = min(DEVICES, key=many.get)
    near = max(many.values()) < 1.25 * many[cheaper]
    put("launch/many", "cost nearly the same" if near else f"cost less in {leads.NAMES[cheaper]}",
        rows["cuda"][1000].source, "words made from launches back to back")
    for name in DEVICES:
        for count, key in ((1, "one"), (1000, "many")):
            put(f"launch/{key}/{name}", f"{1e3 * rows[name][count].median / count:.1f}", rows[name][count].source,
                f"microseconds a launch, {name}, {count} between two waits")


def first_uses(put, machine, others):
    """Of triangle, in groups of every size and every process."""
    def put_span(key, found, what):
        put(f"first/{key}", f"{ms(min(found))} to {ms(max(found))}", source, f"first uses of triangle, ms, {what}")

    for name in DEVICES:
        rows = machine.need(table="methods", backend=name, method="collide_triangle")
        source = rows[0].source
        firsts = [each["first_step_ms"] for row in rows for each in row.parameters.get("processes") or [row.parameters]]
        if name == "cuda":
            put_span(name, firsts, "CUDA")
            continue
        cached, compiled = ([time for time in firsts if (time > COMPILED) is made] for made in (False, True))
        if not (cached and compiled):
            raise Missing(f"{machine.name} has no first uses both with the driver's cache and without")
        put_span("opengl/cached", cached, "GLSL, the driver's cache has the program")
        put_span("opengl/compiled", compiled, "GLSL, the driver compiles it")


def arrangements(put, machine, others):
    for name in DEVICES:
        tiled, square, triangle = (best(machine, name, f"collide_{m}") for m in ("tiled", "square", "triangle"))
        said(machine, tiled.median > 8 * triangle.median, "the arrangement gains an order of magnitude")
        put(f"gain/square/{name}", f"{tiled.median / square.median:.1f}", square.source, f"{name}, tiled/square")
        put(f"gain/triangle/{name}", f"{square.median / triangle.median:.1f}", square.source,
            f"{name}, square/triangle")
        put(f"gain/all/{name}", f"{tiled.median / triangle.median:.0f}", square.source, f"{name}, tiled/triangle")


def group_sizes(put, machine, others):
    """The cost of the worst size, and of the same size everywhere."""
    behind = []
    for name in DEVICES:
        for method in ("tiled", "square", "triangle"):
            rows = machine.need(table="methods", backend=name, method=f"collide_{method}")
            worst, least = (bound(rows, key=lambda record: record.median) for bound in (max, min))
            same = machine.one(table="methods", backend=name, method=f"collide_{method}", block=GROUP)
            behind.append(100 * (same.median / least.median - 1))
            put(f"groups/{method}/{name}", f"{worst.median / least.median:.2f}", worst.source,
                f"{name}, slowest group size ({worst.block}) over fastest ({least.block}), {method}")
            put(f"groups/{method}/{name}/worst", f"{worst.block}", worst.source, f"{name}, slowest, {method}")
    said(machine, max(behind) <= 10, f"groups of {GROUP} are good for every method of all pairs")
    put("groups/same", str(GROUP), machine.id, "the group size that serves every method")
    put("groups/same/behind", f"{max(behind):.0f}", machine.id, f"most in % that groups of {GROUP} are behind the best")


def keeping_order(put, machine, others):
    """Compares the gain of cell order with that of the API."""
    wanted = {"table": "grid", "scene": "uniform", "method": "collide_grid", "packing_fraction": 0.3}
    warm, cold = ({pair[0].n: pair for pair in matched(machine, **wanted, order=order)} for order in ("warm", "cold"))
    n = max(warm.keys() & cold.keys())
    gain = min(slow.median / fast.median for slow, fast in zip(cold[n], warm[n]))
    api = max(time_ratio(*pair).middle for pair in (warm[n], cold[n]))
    said(machine, gain > api and all(ratio.decided for ratio in family(list(zip(cold[n], warm[n])))),
         "cell order gains more than the API")
    put("order/gain", f"{gain:.1f}", warm[n][0].source, f"random over cell order at n = {n}, the smaller of both APIs")


LEADING = (who_leads, short_steps, all_contests, plain_means, one_launch, methods, repeats, launches, first_uses, arrangements, group_sizes, keeping_order)
