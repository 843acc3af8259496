# SPDX-License-Identifier: MIT
"""Numbers of the prose from the studies: the sweep, frames, transfers."""
import statistics

from paper.numbers import leads
from paper.numbers.derived import BEYOND_EMPTY, INSTRUCTIONS, copy_rate, crossover, grid_share_of_floor, kernels_alone, matched, slope, timer_floor
from paper.numbers.ratios import extent, family, time_ratio
from paper.numbers.transfers import MOST_TRANSFERRED
from paper.records import Missing, said
from paper.text import ms

DEVICES = ("opengl", "cuda")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid"}
SIZE = 16384
CLOSE = 0.04  # of CUDA's time: a kernel that is as fast


def pairs_of_the_sweep(put, machine, others):
    """All pairs in the sweep, which is a separate run."""
    wanted = {"table": "grid", "method": "collide_triangle", "order": "cold", "scene": "uniform"}
    found = leads.decided([pair for fraction in fractions(machine)
                           for pair in matched(machine, **wanted, packing_fraction=fraction) if pair[0].n >= leads.LARGE])
    if not found:
        raise Missing(f"{machine.name}: the sweep has no all pairs of {leads.LARGE:,} spheres and more")
    large = [entry for entry in leads.contests(machine) if entry.n >= leads.LARGE] + found
    sides = {entry.winner for entry in large} - {""}
    put("lead/turns", "So the lead changes sides between scenes and runs." if len(sides) > 1 else
        "So the lead is on one side in both runs, where there is any.", found[0].source, "sentence made from both runs")
    others_found = leads.decided([
        pair for method in ("collide_tiled", "collide_square") for fraction in fractions(machine)
        for pair in matched(machine, **{**wanted, "method": method}, packing_fraction=fraction) if pair[0].n >= leads.LARGE])
    said(machine, others_found and all(entry.winner == "cuda" for entry in others_found), "CUDA leads in tiled and square at large sizes")
    put("lead/other-methods", leads.ratios(others_found), found[0].source,
        f"time ratios GLSL/CUDA of tiled and square in the sweep, from {leads.LARGE} spheres on")
    put("lead/sweep", leads.at_large_sizes(found).replace(" %", "\\,\\%"), found[0].source,
        "sentence made from all pairs in the sweep")


def kernel_pairs(put, machine, others):
    """The program's kernels by device timers, without their launches."""
    rows = kernels_alone(machine)
    source = ", ".join(dict.fromkeys(row.source for row in rows))
    ratios = [row.ratio[0] for row in rows]
    put("kernels/all", str(len(rows)), source, f"kernels that take {BEYOND_EMPTY} times an empty one's reading in both, variants once")
    put("kernels/median", f"{statistics.median(ratios):.2f}", source, "GLSL's time over CUDA's, their median")
    put("kernels/close", str(sum(abs(ratio - 1) <= CLOSE for ratio in ratios)), source, f"kernels within {100 * CLOSE:.0f} % of CUDA's time")
    put("kernels/close/percent", f"{100 * CLOSE:.0f}", source, "%, what counts as close")
    put("kernels/list", ", ".join(f"\\kernel{{{row.kernel}}} {row.ratio[0]:.2f}" for row in rows), source, "each kernel's ratio, greatest first")
    for key, row in zip(("worst", "second"), rows):
        put(f"kernels/{key}", f"{row.ratio[0]:.2f}x", source, f"{key} ratio, {row.kernel}, {row.where}")
        put(f"kernels/{key}/name", row.kernel, source, "its kernel")
    put("kernels/floor", f"{1e3 * timer_floor(machine):.1f}", machine.id, "us, most that a device timer reads of an empty kernel")
    put("kernels/least", f"{1e3 * BEYOND_EMPTY * timer_floor(machine):.0f}", machine.id, f"us, {BEYOND_EMPTY} times that")


def loops_of_triangle(put, machine, others):
    """Instructions of the hot loop, as both compilers made it."""
    record = machine.source("listings.json")
    found = {row["backend"]: row for row in record["listings"] if row["kernel"] == "collide_triangle"}
    pairs = {row["pairs"] for row in found.values()}
    said(machine, found.keys() == set(DEVICES) and len(pairs) == 1, "both compilers' loops test as many pairs")
    put("loop/pairs", str(*pairs), record["id"], "pairs of a turn of the hot loop of triangle")
    put("loop/least", str(INSTRUCTIONS * next(iter(pairs))), record["id"], "the least instructions for them")
    for name in DEVICES:
        put(f"loop/{name}", str(found[name]["loop"]["instructions"]), record["id"], f"instructions of the hot loop of triangle, {name}")


def grid(put, machine, others):
    largest = max(glsl.n for glsl, _ in matched(machine, **GRID, packing_fraction=0.3, order="cold"))
    put("grid/largest", f"{largest:,}", machine.need(**GRID)[0].source, "largest n of the grid in both APIs, cold")
    least = machine.need(table="grid", scene="uniform", packing_fraction=0.3, method="collide_triangle")[0]
    put("grid/smallest", f"{least.n:,}", least.source, "least n at which the grid and all pairs were timed")
    put("copy/rate", f"{copy_rate(machine) / 1e12:.2f}", machine.id, "10^12 bytes/s: the highest copy rate recorded, either API")
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
                put(f"grid/floor/{name}/{order}", f"{grid_share_of_floor(machine, last):.0f}", last.source,
                    f"{last.label}, share of the floor in %, n = {last.n}, {order}")


def largest_grids(put, machine, others):
    for name in DEVICES:
        wanted = {**GRID, "packing_fraction": 0.3, "backend": name}
        rows = {(row.n, row.order): row for row in machine.need(**wanted)}
        both = [n for n, order in rows if order == "warm" and (n, "cold") in rows]
        most = max(both)
        before = sorted(both)[-2]
        slopes = [slope(rows[before, order], rows[most, order]) for order in ("cold", "warm")]
        said(machine, all(0.8 < value < 1.2 for value in slopes),
             f"the grid's time grows nearly in proportion to n at last, in {name}")
        put(f"grid/most/{name}/n", f"{most:,}", rows[most, "cold"].source, f"largest n of the grid, {name}")
        for order in ("cold", "warm"):
            row = rows[most, order]
            put(f"grid/most/{name}/{order}", ms(row.median), row.source, f"{row.label}, n = {most}, {order}")


def grid_leads(put, machine, others):
    """Which API is faster in the grid, over every order and packing fraction, of several processes."""
    pairs = [pair for order in ("cold", "warm") for fraction in fractions(machine)
             for pair in matched(machine, **GRID, packing_fraction=fraction, order=order)]
    found = [(pair[1], ratio) for pair, ratio in zip(pairs, family(pairs)) if ratio.processes > 1]
    if not found:
        raise Missing(f"{machine.name} has no grid of several processes in both APIs")
    clear = [(cuda, ratio.middle) for cuda, ratio in found if ratio.decided]
    wins = {"opengl": [lead for lead in clear if lead[1] < 1], "cuda": [lead for lead in clear if lead[1] > 1]}
    source = found[0][0].source
    put("grid/contests", str(len(found)), source, "sizes, orders and fractions of the grid in both, of several processes")
    put("grid/extent", extent([ratio for _, ratio in found]), source, "what these contests stand on")
    for name, won in wins.items():
        put(f"grid/wins/{name}", str(len(won)), source, f"those in which {name} is the faster")
    put("grid/open", str(len(found) - len(clear)), source, "those that are undecided")
    said(machine, not wins["opengl"] and len(wins["cuda"]) > 0.6 * len(found),
         "CUDA is the faster in most contests of the grid, and in none the slower")
    row, most = max(wins["cuda"], key=lambda lead: lead[1])
    said(machine, row.n <= 1024 and row.order == "warm", "CUDA's lead is greatest for few spheres that are not sorted")
    put("grid/lead/most", f"{most:.2f}x", source, f"greatest time ratio GLSL/CUDA: n = {row.n}, {row.order}")
    put("grid/lead/cold", f"{max(lead for cuda, lead in wins['cuda'] if cuda.order == 'cold'):.2f}x", source,
        "greatest time ratio GLSL/CUDA, cold")
    warm = [lead for cuda, lead in wins["cuda"] if cuda.order == "warm" and cuda.scene["packing_fraction"] == 0.3]
    said(machine, max(warm[:2]) > 1.2 > max(warm[-2:]), "in cell order CUDA's lead is greater for few spheres than for many")
    last = [matched(machine, **GRID, packing_fraction=0.3, order=order)[-1] for order in ("cold", "warm")]
    for (_, cuda), ratio in zip(last, family(last)):
        put(f"grid/last/{cuda.order}", lead_text(ratio), source, f"n = {cuda.n}, {cuda.order}")
        put(f"grid/last/{cuda.order}/extent", extent([ratio]), source, "what it stands on")


def lead_text(ratio):
    return f"OpenGL takes {ratio.middle:.2f}x CUDA's time" if ratio.decided else "it is undecided which API is faster"


def fractions(machine):
    return sorted({row.scene["packing_fraction"] for row in machine.need(**GRID)})


def drawing(put, machine, others):
    rows = {name: machine.need(table="draw", work="frame", place="outside", backend=name) for name in DEVICES}
    pipeline = [row for row in rows["opengl"] if row.n == SIZE and row.draw != "compute"]
    for row in pipeline:
        put(f"draw/pipeline/{row.draw}", ms(row.median), row.source, f"{row.label}, n = {SIZE}")
    both = max({row.n for row in rows["opengl"]} & {row.n for row in rows["cuda"]})
    put("draw/both", f"{both:,}", rows["cuda"][0].source, "most spheres drawn through both APIs")
    for name in DEVICES:
        step = machine.one(**GRID, packing_fraction=0.3, order="warm", backend=name, n=both).median
        share = min(row.median for row in rows[name] if row.n == both) / step
        put(f"draw/share/{name}", f"{100 * share:.0f}", rows[name][0].source, f"% of a step in cell order, n = {both}")
        drawn = [row for row in rows[name] if row.draw == "compute"]
        said(machine, drawn[-1].n / drawn[0].n > 4 * drawn[-1].median / drawn[0].median,
             f"a frame's time grows far more slowly than the number of spheres in {name}")
        for n, key in ((both, "both"), (rows[name][-1].n, "most")):
            best_way = min((row for row in rows[name] if row.n == n), key=lambda row: row.median)
            put(f"draw/{key}/{name}", ms(best_way.median), best_way.source, f"{best_way.label}, n = {n}")
            put(f"draw/{key}/{name}/n", f"{n:,}", best_way.source, f"{name}, spheres drawn from outside")
            put(f"draw/{key}/{name}/way", best_way.draw, best_way.source, f"{name}, fastest way to draw {n} spheres")
    for work, key in (("frame", "draw/behind"), ("lit", "draw/behind/lit")):
        ratio, cuda = max(((time_ratio(*pair).middle, pair[1]) for place in ("outside", "inside")
                           for pair in matched(machine, table="draw", draw="compute", work=work, place=place)), key=lambda found: found[0])
        put(key, f"{ratio:.2f}x", cuda.source, f"greatest time ratio GLSL/CUDA of the rasteriser: {work}, {cuda.place}, n = {cuda.n}")


def loops(put, machine, others):
    rows = {name: {row.n: row for row in machine.need(table="draw", work="loop", place="outside", backend=name)}
            for name in DEVICES}
    n = min(rows["opengl"].keys() & rows["cuda"].keys())
    put("loop/n", f"{n:,}", rows["cuda"][n].source, "least spheres of the loop in both APIs")
    for name in DEVICES:
        row = rows[name][n]
        put(f"loop/rate/{name}", f"{1e3 / row.median:,.0f}", row.source, f"frames per second, {row.label}, n = {n}")


def transfers(put, machine, others):
    rows = [row for row in machine.need(table="interop") if row.n <= MOST_TRANSFERRED]
    most = max(row.n for row in rows)
    rows = sorted((row for row in rows if row.n == most), key=lambda row: row.median)
    put("interop/n", f"{rows[0].n:,}", rows[0].source, "most spheres transferred")
    order = [row.way.split("'")[0] for row in rows]
    said(machine, order == ["CUDA", "GL", "through the host"],
         "imported memory is transferred fastest, through the host slowest")
    for key, row in (("fast", rows[0]), ("middle", rows[1]), ("slow", rows[-1])):
        put(f"interop/{key}", ms(row.median), row.source, f"ms, {row.way}, n = {row.n}")
        put(f"interop/{key}/way", row.way, row.source, f"the {key}est transfer, n = {row.n}")


STUDIED = (pairs_of_the_sweep, kernel_pairs, loops_of_triangle, grid, largest_grids, grid_leads, drawing, loops, transfers)
