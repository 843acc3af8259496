# SPDX-License-Identifier: MIT
"""Tables of the studies that have runs of their own: the stress catalogue, peers, crossovers, hand-overs."""
import re
from dataclasses import dataclass

from crossovers import crossovers_by_kind
from ranks import verdict
from records import Missing
from records import peers as measured_peers
from tabular import Table, interval, ms

DEVICES = ("cuda", "glsl")
GRID = {"table": "grid", "scene": "uniform", "method": "collide_grid"}
ROWS = range(1, 34)  # of the catalogue
STRESS = ("The stress catalogue: what each row sets up, what was found, what had to hold, and on which backends "
          "it did. A figure without a name is that of every backend.")
PEERS = ("Milliseconds from so many centres on the GPU, in random order and of the packing fraction below, to the"
         " number of colliding pairs, or to what else a system offers: ours beside other systems on the same "
         "centres. The others were timed in one run of their own ({run}), on an H200 too, as medians without "
         "intervals; wrong pairs are of the last column. Ours:")
CROSSOVERS = ("The least $n$ up to {most:,} from which the grid stays ahead of all pairs, as intervals or the rank test tell, by the"
              " kind of spheres, and how many times the best fixed choice the program's own (auto) took at worst;"
              " 1 where no difference is seen, or where it took the same.")
HAND_OVERS = ("CUDA steps, OpenGL draws {draw}: a picture with its hand-over, a step, both in a loop that waits for "
              "nothing but the hand-over, and what that hides of the sum of the two; medians, in brackets what their "
              "intervals allow.")
MOST_HANDED_OVER = 10**6  # spheres of the prose; with more, GL's points take longer than all else
HAND_OVERS_ALONE = {"none": ("host", "registered", "imported")}  # beside them stand those with a picture
LOOPS = ("A whole loop, the first 20 steps of a fall: move, collide through the grid, draw; and the pictures a second "
         "that this makes. From CUDA to GL: CUDA steps and OpenGL draws {draw}, by the fastest hand-over, pipelined.")


@dataclass
class Stressed:
    """One test of a row of the catalogue, on every backend that it ran on."""
    row: int
    scene: str
    what: str
    bound: str
    verdicts: dict  # backend, or all -> verdict
    figures: dict


def in_thousands(text):
    """10000000 -> 10,000,000, where it is a number of its own."""
    return re.sub(r"(?<![\w.,^+-])\d{5,}(?![\w.])", lambda number: f"{int(number[0]):,}", text)


def stressed(machine):
    tests = {}
    for entry in machine.source("stress.json")["rows"]:
        test = tests.setdefault((entry["row"], entry["what"]), Stressed(
            entry["row"], entry["scene"], entry["what"], entry["bound"], {}, {}))
        test.verdicts[entry["backend"]] = entry["verdict"]
        if entry["verdict"] != "skipped":
            test.figures[entry["backend"]] = in_thousands(entry["figure"])
    found = list(tests.values())
    failed = [f"{test.row}: {test.what}" for test in found if "FAIL" in test.verdicts.values()]
    if failed:
        raise Missing(f"{machine.name}: rows of the stress catalogue failed, {', '.join(failed)}")
    absent = [str(row) for row in ROWS if not any(test.row == row and test.figures for test in found)]
    if absent:
        raise Missing(f"{machine.name}: rows {', '.join(absent)} of the stress catalogue were not run")
    return found


def recorded_stress(machines):
    """The first machine that has a record of the catalogue."""
    found = [machine for machine in machines if "stress.json" in machine.sources]
    if not found:
        raise Missing("no machine has a stress.json")
    return found[0]


def figure_text(figures):
    """One for all backends that found the same, else each with who found it."""
    owners = {}
    for backend, figure in figures.items():
        owners.setdefault(figure, []).append(backend)
    if len(owners) == 1:
        return next(iter(owners)) or "-"
    return "; ".join(f"{', '.join(name.upper() for name in names)}: {figure}" for figure, names in owners.items())


def stress(machine):
    rows, last = [], None
    for test in stressed(machine):
        verdicts = [test.verdicts.get(name, test.verdicts.get("all", "-") if machine.has(name) else "-")
                    for name in ("cpu", "glsl", "cuda")]
        verdicts = ["-" if verdict == "skipped" else verdict for verdict in verdicts]
        first = test.row != last
        rows.append([str(test.row) if first else "", test.scene if first else "", test.what,
                     figure_text(test.figures), test.bound, *verdicts])
        last = test.row
    columns = ("r", *(f">{{\\raggedright\\arraybackslash}}p{{{width}mm}}" for width in (29, 25, 49, 25)), "l", "l", "l")
    heads = [[("", 1)] * 8, ["row", "scene", "what is tested", "figure", "bound", "CPU", "GLSL", "CUDA"]]
    return Table("stress", STRESS, heads, rows, left=8, columns=columns, source=machine.source("stress.json")["id"],
                 long=True)


def ours(machine, name, sizes):
    cells = []
    for n, fraction in sizes:
        found = machine.select(**GRID, order="cold", backend=name, n=n, packing_fraction=fraction)
        cells.append(ms(found[0].median) if found else "-")
    return [f"this paper, {name.upper()}", "count", *cells, "0"]


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
    return Table("peers", PEERS.format(run=record["id"]), heads, rows, left=2,
                 source=", ".join(dict.fromkeys(row.source for row in machine.need(**GRID, order="cold"))))


def crossover(machine):
    found = crossovers_by_kind(machine)
    names = [name for name in ("cpu", "glsl", "cuda") if any(name in by_backend for by_backend in found.values())]
    rows = []
    for kind, by_backend in found.items():
        row = [kind]
        for name in names:
            result = by_backend.get(name)
            row += ["-", "-"] if result is None else [result.start, result.loss]
        rows.append(row)
    heads = [[("", 1), *((name.upper(), 2) for name in names)], ["spheres", *["grid from", "auto"] * len(names)]]
    most = max(row.n for row in machine.need(table="crossover"))
    return Table("crossover", CROSSOVERS.format(most=most), heads, rows, source=next(iter(by_backend.values())).source)


def grid_sizes(machine):
    rows, sources = [], []
    for fraction in (0.3, 0.05):
        wanted = {**GRID, "packing_fraction": fraction}
        for n in sorted({row.n for row in machine.need(**wanted)}):
            cells = [f"{fraction:g}", size_text(n)]
            for order in ("warm", "cold"):
                glsl, cuda = (machine.select(**wanted, n=n, order=order, backend=name) for name in ("glsl", "cuda"))
                cells += [interval(found[0]) if found else "-" for found in (glsl, cuda)]
                cells.append(verdict(glsl[0], cuda[0]).removesuffix(" faster") if glsl and cuda else "-")
                sources += [found[0].source for found in (glsl, cuda) if found]
            rows.append(cells)
    heads = [[("packing", 1), ("", 1), ("in cell order, ms", 3), ("in random order, ms", 3)],
             ["fraction", "spheres", *["GLSL", "CUDA", "faster"] * 2]]
    return Table("grid-sizes", "A collision step through the grid: medians and their intervals.", heads, rows, left=0,
                 source=", ".join(dict.fromkeys(sources)))


def overlaps(machine):
    """Of all records of hand-overs, as if they were one."""
    roots = [root for root in machine.sources.values() if root.get("overlaps")]
    if not roots:
        raise Missing(f"{machine.name} has no record of `spherepair frames --hand-over`")
    whole = {key: [entry for root in roots for entry in root[key]] for key in ("overlaps", "frames")}
    return whole | {"id": ", ".join(root["id"] for root in roots)}


def hidden(root, entry):
    """What pipelining saves, ms, and what the intervals of the three medians allow; negative where it costs."""
    rows = {row["work"]: row for row in root["frames"] if row["n"] == entry["n"] and
            row["draw"] in (entry["draw"], "none") and row["work"] not in HAND_OVERS_ALONE.get(row["draw"], ())}
    (least, most), (step_least, step_most), (both_least, both_most) = (
        rows[work]["interval_ms"] for work in (entry["hand_over"], "step", f"{entry['hand_over']}_pipelined"))
    return (entry["picture_ms"] + entry["step_ms"] - entry["pipelined_ms"], least + step_least - both_most,
            most + step_most - both_least)


def hand_over(machine):
    rows, root = [], overlaps(machine)
    for entry in root["overlaps"]:
        times = [entry[f"{what}_ms"] for what in ("picture", "step", "pipelined")]
        middle, least, most = hidden(root, entry)
        rows.append([entry["hand_over"], size_text(entry["n"]), *map(ms, times),
                     f"{ms(middle)} [{ms(least)}, {ms(most)}]"])
    heads = [[("", 2), ("milliseconds", 4)], ["way", "spheres", "picture", "step", "both", "hidden"]]
    caption = HAND_OVERS.format(draw=root["overlaps"][0]["draw"])
    return Table("hand-over", caption, heads, rows, left=1, source=root["id"])


def loop(machine):
    handed = overlaps(machine)
    rows, sources = [], [handed["id"]]
    for place in ("outside", "inside"):
        for n in sorted({row.n for row in machine.need(table="draw", work="loop") if row.place == place}):
            glsl, cuda = (machine.select(table="draw", work="loop", place=place, n=n, backend=name)
                          for name in ("glsl", "cuda"))
            cells = [f"{interval(found[0])}" if found else "-" for found in (glsl, cuda)]
            rates = [f"{1e3 / found[0].median:,.0f}" if found else "-" for found in (glsl, cuda)]
            across = min((entry["pipelined_ms"] for entry in handed["overlaps"] if entry["n"] == n), default=None)
            known = across is not None and place == "outside"
            rows.append([place, size_text(n), *cells, ms(across) if known else "-", *rates,
                         f"{1e3 / across:,.0f}" if known else "-",
                         verdict(glsl[0], cuda[0]).removesuffix(" faster") if glsl and cuda else "-"])
            sources += [found[0].source for found in (glsl, cuda) if found]
    heads = [[("", 2), ("median [interval], ms", 3), ("pictures a second", 3), ("", 1)],
             ["camera", "spheres", *["GLSL", "CUDA", "to GL"] * 2, "faster"]]
    caption = LOOPS.format(draw=handed["overlaps"][0]["draw"])
    return Table("loop", caption, heads, rows, left=1, source=", ".join(dict.fromkeys(sources)))


STUDIED = (stress, grid_sizes, peers, crossover, hand_over, loop)
