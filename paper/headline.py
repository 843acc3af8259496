# SPDX-License-Identifier: MIT
"""The README's headline from recorded runs: the rows of its table that can be made, found by their first words."""
import re

from derived import cost, pairs_of
from records import original_paper

SIZE = 16384
MANY = 10**7  # through the grid
DEVICES = ("glsl", "cuda")


def short(milliseconds):
    digits = 3 if milliseconds < 0.1 else 2 if milliseconds < 10 else 0
    return f"{milliseconds:.{digits}f}"


def medians(machine, **wanted):
    return [f"{short(machine.one(backend=name, n=SIZE, **wanted).median)} ms" for name in DEVICES]


def through_the_grid(machine, order):
    wanted = {"table": "grid", "n": MANY, "packing_fraction": 0.3, "method": "collide_grid"}
    cpu = machine.one(backend="cpu", order="cold", **wanted).median if order == "cold" else None
    cells = [f"{short(machine.one(backend=name, order=order, **wanted).median)} ms" for name in DEVICES]
    return cells + [f"{short(cpu)} ms" if cpu else "-"]


def rows(machine):
    """(first words, the whole row)."""
    last, threads = original_paper()["table1"][-1], machine.main["context"]["machine"]["hardware_threads"]
    cpu = {what: short(machine.one(backend="cpu", n=SIZE, **wanted).median) for what, wanted in {
        "step": {"table": "step"}, "one": {"table": "table1", "method": "sequential"},
        "all": {"table": "table1", "method": "parallel"}}.items()}
    rates = []
    for name in DEVICES:
        record = machine.need(table="scale", scene="uniform", backend=name)[-1]
        rates.append(f"{0.5 * record.n * (record.n - 1) / record.median / 1e9:.2f}·10¹²")
    costs = {exact.backend: cost(naive, exact)[0] for exact, naive in pairs_of(machine)
             if exact.method == "collide_triangle"}
    made = [("whole step of 16,384 spheres", f": motion, plane, all pairs, counts (the paper: {last[6]} ms parallel, "
             f"{last[4] + last[5]:,} ms sequential)", *medians(machine, table="step"),
             f"{cpu['step']} ms on {threads} cores"),
            ("the same spheres' pairs alone", "", *medians(machine, table="table1", method="collide_triangle"),
             f"{cpu['all']} ms; one thread, serial: {cpu['one']} ms"),
            ("pairs of 10,000,000 spheres through the grid", ", packing fraction 0.3, in cell order",
             *through_the_grid(machine, "warm")),
            ("the same in random order", ", sorted first", *through_the_grid(machine, "cold")),
            ("pairs tested a second", ", n = 2²⁰, packing fraction 0.3", *rates, "-"),
            ("the paper's own tile", ", 16,384 spheres", *medians(machine, table="table1", method="collide_tiled"),
             "-"),
            ("what exactness costs", " at 16,384 spheres", *(f"{costs[name]:.1f} %" for name in DEVICES),
             "no difference seen")]
    return [(words, f"| {words}{rest} | {' | '.join(cells)} |") for words, rest, *cells in made]


def updated(readme, machine):
    """The README with these rows replaced; every row must be there."""
    for words, row in rows(machine):
        readme, count = re.subn(rf"^\| {re.escape(words)}.*$", lambda _: row, readme, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"the README has {count} rows that begin with: {words}")
    return readme
