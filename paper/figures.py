#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws every figure and table that recorded runs allow.

  paper/figures.py                                from paper/data/h100 to build/paper, with the numbers of paper.tex
  paper/figures.py --headline                     the image paper/headline.png, and what README.md and docs/motion.md say of paper/data/h100
  paper/figures.py --data FOLDER... --output F    from those folders, each to its own folder, and side by side
"""
import argparse
import contextlib
import importlib
import pkgutil
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[0] = str(ROOT)  # in place of paper/, whose numbers/ would hide Python's module of that name

from paper import docs_facts, headline, images, plots, side_by_side, sources, style  # noqa: E402  (the path must be set first)
from paper.numbers import macros  # noqa: E402
from paper.plots import ratio_by_duration  # noqa: E402
from paper.records import DATA, MAIN, Machine, Missing  # noqa: E402
from paper.tables import all_tables  # noqa: E402
from paper.tables.stress import stress  # noqa: E402
from paper.text import escape, plain  # noqa: E402


def modules():
    names = [f"{room.__name__}.{found.name}" for room in (images, plots) for found in pkgutil.iter_modules(room.__path__)]
    return [importlib.import_module(name) for name in sorted(names, key=lambda name: name.rpartition(".")[2])]


def runs_of(module, machine):
    """The ids of the sources of a figure that was just drawn: those that it names, or those of the records that it used."""
    named = module.source(machine) if hasattr(module, "source") else ""
    used = {record.source for record in machine.used.values()}
    return machine.ids_in(named) or machine.ids_in(" ".join(used)) or [machine.id]


def draw_all(machine, folder):
    """Returns (names drawn, names left out with reasons); a figure without all of its data is not drawn."""
    drawn, left_out = [], []
    style.name_devices(machine)
    for module in modules():
        machine.used.clear()
        try:
            figure = module.draw(machine)
        except Missing as reason:
            left_out.append((module.NAME, str(reason)))
            for kind in ("pdf", "png"):
                (folder / f"{module.NAME}.{kind}").unlink(missing_ok=True)  # of an earlier run
            continue
        machine.runs[module.NAME] = runs_of(module, machine)
        source = machine.title_of(machine.runs[module.NAME])
        note = machine.note_on(module.NAME, source if hasattr(module, "source") else "")
        style.save(figure, folder, module.NAME, f"{source}\n{note}".strip())
        drawn.append(module.NAME)
    return drawn, left_out


def report(machine, folder):
    """Draws and writes what the records allow and reports the rest; returns (figures, tables, reasons by name)."""
    drawn, left_out = draw_all(machine, folder)
    written, unwritten = all_tables.write_all(machine, folder)
    print(f"{machine.title}\n  figures: {', '.join(drawn)}\n  tables: {', '.join(written)}")
    for name, reason in left_out + unwritten:
        print(f"  {name} is left out: {reason}")
    return drawn, written, dict(left_out + unwritten)


def write_captions(machine, path):
    """The captions of the figures and tables that were made, with what is stale in them; their runs are in runs.tex."""
    captions = {}
    for module in modules():
        with contextlib.suppress(Missing):
            captions[module.NAME] = module.caption(machine) if hasattr(module, "caption") else module.CAPTION
    captions |= {table.name: table.caption for table in all_tables.all_tables(machine)}
    lines = [f"\\definecaption{{{name}}}{{{text}{escape(stale_text(machine.notes.get(name)))}}}" for name, text in captions.items()]
    path.write_text("\n".join(lines) + "\n")


def stale_text(note):
    return f" {note[0].upper()}{note[1:]}." if note else ""


def write_runs(machine, tex, made, path):
    """The appendix's list: the figures and tables of the paper by the runs and hosts that they come from."""
    wanted = [name for name in re.findall(r"\\recorded\w+(?:\[[^]]*\])?\{([\w-]+)\}", tex) if name in made and name in machine.runs]
    together = {}
    for name in dict.fromkeys(wanted):
        kind = ("Figure", "fig") if (path.parent / f"recorded/{name}.pdf").exists() else ("Table", "tab")
        together.setdefault(machine.title_of(machine.runs[name]), []).append(f"{kind[0]}~\\ref{{{kind[1]}:{name}}}")
    path.write_text("".join(f"\\item {', '.join(names)}: {escape(title)}.\n" for title, names in together.items()))


def write_stress(machine, output):
    """The stress catalogue of a machine without a GPU, if the main machine has none."""
    table = all_tables.of_one(stress, machine)
    all_tables.write(table, machine, output / "recorded")
    text = f"{table.caption} {escape(all_tables.table_title(table, machine))}."
    with (output / "captions.tex").open("a") as captions:
        captions.write(f"\\definecaption{{{table.name}}}{{{text}}}\n")
    return table.name


def write_paper_inputs(output):
    machine, other = Machine(DATA / MAIN), Machine(DATA / "llvmpipe")
    drawn, written, _ = report(machine, output / "recorded")
    write_captions(machine, output / "captions.tex")
    if "stress" not in written:
        written.append(write_stress(other, output))
    tex = (ROOT / "paper/paper.tex").read_text()
    numbers = macros.collect(machine, [other])
    macros.check(tex, numbers, drawn + written)
    macros.write(numbers, tex, output / "numbers.tex", drawn + written)
    write_runs(machine, tex, drawn + written, output / "runs.tex")
    print(f"  numbers: {len(macros.used_keys(tex, drawn + written))} in the text, each from a recorded run")


def write_headline(machine):
    ratio_by_duration.draw_headline(machine).savefig(ROOT / "paper/headline.png", dpi=220, metadata={"Software": None})
    readme = ROOT / "README.md"
    readme.write_text(headline.updated(readme.read_text(), machine))
    for page in docs_facts.PAGES:
        (ROOT / page).write_text(docs_facts.updated(page, (ROOT / page).read_text(), machine))


def captions(machines):
    """name -> its caption as plain text, by the first machine that has it."""
    found = {}
    for machine in machines:
        for module in modules():
            with contextlib.suppress(Missing):
                text = module.caption(machine) if hasattr(module, "caption") else module.CAPTION
                found.setdefault(module.NAME, plain(text))
        for table in all_tables.all_tables(machine):
            found.setdefault(table.name, plain(table.caption))
    return found


def draw_side_by_side(machines, output):
    """What a machine lacks is listed at the page's end, with the reasons."""
    figures, tables_made, reasons = {}, {}, {}
    for machine in machines:
        drawn, written, left_out = report(machine, output / machine.name)
        figures.update(dict.fromkeys(drawn))
        tables_made.update(dict.fromkeys(written))
        reasons.update({(machine.name, name): reason for name, reason in left_out.items()})
    print(f"Side by side: {side_by_side.write(output, machines, figures, tables_made, reasons, captions(machines))}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, nargs="+", help="folders of recorded runs")
    parser.add_argument("--headline", action="store_true", help="only the image and what README.md and docs/motion.md say of records")
    parser.add_argument("--output", type=Path, default=ROOT / "build/paper", help="where the files go")
    options = parser.parse_args()
    if options.headline:
        write_headline(Machine(DATA / MAIN))
    elif options.data:
        draw_side_by_side([Machine(folder) for folder in options.data], options.output)
    else:
        write_paper_inputs(options.output)


if __name__ == "__main__":
    try:
        main()
    except (Missing, sources.Unknown) as reason:
        sys.exit(f"figures: {reason}")
