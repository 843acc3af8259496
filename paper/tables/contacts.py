# SPDX-License-Identifier: MIT
"""The table of contacts: whole steps of a gas, and what sums of impulses in integers take, against those in float32."""
import itertools

from paper.numbers.derived import over_other_sums
from paper.numbers.ratios import LEGEND, texts
from paper.records import Missing
from paper.tables.studies import size_text
from paper.tables.tabular import Table
from paper.text import ms

DEVICES = ("opengl", "cuda")
CAPTION = ("A gas with contacts, packing fraction {fraction:g}. Whole steps (motion, walls, contacts, lists of near pairs): the "
           "mean of the first {steps:,}, in milliseconds{cpu}. Integers over float32: the time of a step whose impulses are "
           "added up as integers over that of one with float32 sums. " + LEGEND)


def contacts(machine):
    steps = {(row.n, row.backend): row for row in machine.need(table="gas_steps")}
    sums = [over_other_sums(machine, name) for name in ("in_order", "atomics")]
    rows, pairs = [], []
    for n in sorted({n for n, _ in (*steps, *sums[0])}):
        whole = [steps.get((n, name)) for name in ("cpu", *DEVICES)]
        rows.append([size_text(n), *("-" if row is None else ms(row.median / row.steps) for row in whole)])
        pairs += [whole[1:] if all(whole[1:]) else None, *(found.get((n, name)) for found in sums for name in DEVICES)]
    ratios = iter(texts(pairs))
    rows = [[*row, *itertools.islice(ratios, 5)] for row in rows]
    counted = {row.steps for row in steps.values()}
    if len(counted) != 1:
        raise Missing(f"{machine.name} has steps with contacts that are means of different numbers: {counted}")
    heads = [[("", 1), ("whole step, ms", 4), ("integers over float32 in order", 2), ("integers over atomics", 2)],
             ["spheres", "CPU", "OpenGL", "CUDA", "OpenGL/CUDA", *["OpenGL", "CUDA"] * 2]]
    sources = [row.source for row in steps.values()] + [row.source for row in machine.select(table="contact_sums")]
    caption = CAPTION.format(fraction=machine.source("contacts.json")["settings"]["packing_fraction"], steps=counted.pop(),
                             cpu=cpu_text(machine))
    return Table("contacts", caption, heads, rows, left=0, source=", ".join(dict.fromkeys(sources)))


def cpu_text(machine):
    """Of how many threads and rounds the CPU's time is, if it has one."""
    rounds = [len(row.samples_ms) for row in machine.select(table="gas_steps", backend="cpu")]
    threads = [backend["details"]["threads"] for root in machine.sources.values() if root.get("gas_steps")
               for backend in root["backends"] if backend["name"] == "cpu"]
    return f", on {threads[0]} threads of the CPU in {rounds[0]} rounds" if rounds else ""
