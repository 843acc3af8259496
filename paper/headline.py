# SPDX-License-Identifier: MIT
"""The README's headline from recorded runs: the rows of its table, found by their first words, and the comparison of
the APIs."""
import re
import textwrap

from paper.numbers import contests, leads
from paper.numbers.derived import cost, matched, pairs_of
from paper.numbers.ratios import differ
from paper.records import original_paper

SIZE = 16384
MANY = 10**7  # through the grid
DEVICES = ("glsl", "cuda")


def short(milliseconds):
    digits = 3 if milliseconds < 0.1 else 2 if milliseconds < 10 else 0
    return f"{milliseconds:.{digits}f}"


def medians(machine, **wanted):
    return [f"{short(machine.one(backend=name, n=SIZE, **wanted).median)} ms" for name in DEVICES]


def with_doubt(record):
    """Milliseconds, with the interval if it is wide: the CPU's cores are shared with other hosts."""
    wide = record.high - record.low > 0.1 * record.median
    return f"{short(record.median)} ms" + (f" [{short(record.low)}, {short(record.high)}]" if wide else "")


def through_the_grid(machine, order):
    wanted = {"table": "grid", "n": MANY, "packing_fraction": 0.3, "method": "collide_grid"}
    cpu = machine.one(backend="cpu", order=order, **wanted).median
    cells = [f"{short(machine.one(backend=name, order=order, **wanted).median)} ms" for name in DEVICES]
    return cells + [f"{short(cpu)} ms"]


def pushing(machine):
    found = [machine.one(table="gas_steps", n=MANY, backend=name) for name in DEVICES]
    return [f"{short(record.median / record.steps)} ms" for record in found]


def frames(machine):
    wanted = {"table": "draw", "n": MANY, "draw": "compute", "work": "frame", "place": "outside"}
    return [f"{short(machine.one(backend=name, **wanted).median)} ms" for name in DEVICES]


def rows(machine):
    """(first words, the whole row)."""
    last, threads = original_paper()["table1"][-1], machine.threads
    cpu = {what: with_doubt(machine.one(backend="cpu", n=SIZE, **wanted)) for what, wanted in {
        "step": {"table": "step"}, "one": {"table": "table1", "method": "sequential"},
        "all": {"table": "table1", "method": "parallel"}, "later": {"table": "exactness", "method": "sequential", "exact": True}}.items()}
    rates = []
    for name in DEVICES:
        record = machine.need(table="scale", scene="uniform", backend=name)[-1]
        rates.append(f"{0.5 * record.n * (record.n - 1) / record.median / 1e9:.2f}·10¹²")
    costs = {(exact.backend, exact.method): f"{cost(naive, exact)[0]:.1f} %" if differ(exact, naive) else
             "no difference seen" for exact, naive in pairs_of(machine)}
    made = [("whole step of 16,384 spheres", f": motion, plane, all pairs, counts (the paper: {last[6]} ms parallel, "
             f"{last[4] + last[5]:,} ms sequential)", *medians(machine, table="step"),
             f"{cpu['step']} on {threads} cores"),
            ("the same spheres' pairs alone", "", *medians(machine, table="table1", method="collide_triangle"),
             f"{cpu['all']}; one thread, serial: {cpu['one']}, later in the run {cpu['later']}"),
            ("pairs of 10,000,000 spheres through the grid", ", packing fraction 0.3, in cell order",
             *through_the_grid(machine, "warm")),
            ("the same in random order", ", sorted first", *through_the_grid(machine, "cold")),
            ("a step of 10,000,000 spheres that push each other", ", mean of 1,000, packing fraction 0.3",
             *pushing(machine), "-"),
            ("a frame of 10,000,000 spheres", ", 1920×1080, compute rasteriser, camera outside", *frames(machine),
             "-"),
            ("pairs tested per second", ", n = 2²⁰, packing fraction 0.3", *rates, "-"),
            ("the paper's own tile", ", 16,384 spheres", *medians(machine, table="table1", method="collide_tiled"),
             "-"),
            ("cost of exactness", " at 16,384 spheres", *(costs[name, "collide_triangle"] for name in DEVICES),
             costs["cpu", "parallel"])]
    return [(words, f"| {words}{rest} | {' | '.join(cells)} |") for words, rest, *cells in made]


def comparison(machine):
    """The paragraph under the table."""
    found = leads.contests(machine)
    wanted = {"table": "grid", "scene": "uniform", "method": "collide_grid"}
    fractions = sorted({row.scene["packing_fraction"] for row in machine.need(**wanted)})
    grid = [leads.contest(*pair) for fraction in fractions for order in ("warm", "cold")
            for pair in matched(machine, **wanted, packing_fraction=fraction, order=order)]
    cuda = leads.won(grid, "cuda")
    text = (f"For all pairs, {leads.headline(found)}: {leads.wins(found)}. Through the grid, whose steps are "
            f"short kernels, GLSL takes {leads.ratios(cuda)} CUDA's time in {len(cuda)} of {len(grid)} comparisons. "
            "Medians of recorded runs with their intervals: [paper/data/h100](paper/data/h100). Design decisions and "
            "rejected alternatives: [docs/NOTES](docs/NOTES/README.md).")
    return filled(text)


def wrong_sets(machine):
    """What the motion gets wrong, by the closed form."""
    root = machine.source("sets.json")
    rows = {(row["method"], row["precision"]): row for row in root["motion"] if row["k"] == 6 and row["offset"] == 0}
    paper, settings = rows["paper", "float32"], root["settings"]
    wrong = {key: row["missed"] + row["extra"] for key, row in rows.items()}
    exact = all(wrong[method, precision] == 0 for method in ("impact", "anchored") for precision in ("compensated", "float64"))
    return (f"After {settings['seconds']:g} s at dt = 2⁻⁶ s, of the {paper['right']:,} pairs of {settings['n']:,} spheres "
            f"float32 `paper` misses {paper['missed']:,} and adds {paper['extra']:,}; `impact` gets "
            f"{wrong['impact', 'float32']:,} wrong and `anchored` {wrong['anchored', 'float32']:,}"
            f"{', in compensated and float64 none' if exact else ''}.")


def filled(text):
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def updated(readme, machine):
    """The README with these rows and paragraphs replaced; each must be there."""
    parts = [(rf"^\| {re.escape(words)}.*$", row) for words, row in rows(machine)]
    for pattern, text in (*parts, (r"^For all pairs,.*(\n.+)*", comparison(machine)),
                          (r"^After .* s at dt = .*(\n.+)*", filled(wrong_sets(machine))),
                          (r"^In [\d,]+ recorded contests.*(\n.+)*", filled(contests.rule(machine)))):
        readme, count = re.subn(pattern, lambda _: text, readme, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"the README has {count} matches of: {pattern}")
    return readme
