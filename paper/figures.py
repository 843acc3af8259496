#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws every figure and table that recorded runs allow.

  paper/figures.py                                from paper/data/h100 to build/paper, with the numbers of paper.tex
  paper/figures.py --headline                     paper/headline.png and paper/apis.png, and what README.md and docs/motion.md say of records
  paper/figures.py --data FOLDER... --output F    the page of those folders, side by side
"""
import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[0] = str(ROOT)  # in place of paper/, whose numbers/ would hide Python's module of that name

from paper import all_figures, docs_facts, headline, sources, style  # noqa: E402  (the path must be set first)
from paper.numbers import macros  # noqa: E402
from paper.page import contents, index, recorded, report  # noqa: E402
from paper.plots import apis as plots_apis, ratio_by_duration  # noqa: E402
from paper.progress import Progress  # noqa: E402
from paper.records import APIS, DATA, MAIN, Machine, Missing  # noqa: E402
from paper.tables import all_tables  # noqa: E402
from paper.tables.apis import apis, opening  # noqa: E402
from paper.tables.stress import stress  # noqa: E402
from paper.text import escape  # noqa: E402


def draw_all(machine, folder, announce=lambda name: None):
    """Returns (figures drawn, names left out with reasons); a figure without all of its data is not drawn."""
    drawn, left_out = [], []
    for made, reason in all_figures.made(machine, announce):
        if reason:
            left_out.append(reason)
            for kind in ("pdf", "png"):
                (folder / f"{reason[0]}.{kind}").unlink(missing_ok=True)  # of an earlier run
            continue
        style.save(made.figure, folder, made.name, f"{made.source}\n{made.note}".strip())
        drawn.append(made)
    return drawn, left_out


def captions(machine, drawn, tables):
    """(name, caption) of each that was made, with what is stale in it; its runs are in runs.tex."""
    for made in (*drawn, *tables):
        if made.caption:
            yield made.name, made.caption + escape(stale_text(machine.notes.get(made.name)))


def stale_text(note):
    return f" {note[0].upper()}{note[1:]}." if note else ""


def write_runs(machines, tex, made, path):
    """The appendix's list: the figures and tables of the paper by the runs and hosts that they come from."""
    titles = {name: machine.title_of(runs) for machine in machines for name, runs in machine.runs.items()}
    wanted = [name for name in re.findall(r"\\recorded\w+(?:\[[^]]*\])?\{([\w-]+)\}", tex) if name in made and name in titles]
    together = {}
    for name in dict.fromkeys(wanted):
        kind = ("Figure", "fig") if (path.parent / f"recorded/{name}.pdf").exists() else ("Table", "tab")
        together.setdefault(titles[name], []).append(f"{kind[0]}~\\ref{{{kind[1]}:{name}}}")
    path.write_text("".join(f"\\item {', '.join(names)}: {escape(title)}.\n" for title, names in together.items()))


def table_elsewhere(maker, machine, folder):
    """(name, caption) of a table of another machine than the paper's, which is written."""
    table = all_tables.of_one(maker, machine)
    all_tables.write(table, machine, folder)
    return table.name, f"{table.caption} {escape(all_tables.table_title(table, machine))}."


def figure_elsewhere(module, machine, folder):
    made = all_figures.drawn(module, machine)
    style.save(made.figure, folder, made.name, f"{made.source}\n{made.note}".strip())
    return made.name, f"{made.caption} {escape(made.source)}."


def write_paper_inputs(output):
    machine, other, progress = Machine(DATA / MAIN), Machine(DATA / "llvmpipe"), Progress()
    three, folder = Machine(DATA / APIS, whole=False), output / "recorded"
    drawn, left_out = draw_all(machine, folder, progress.start)
    progress.start("tables")
    tables, unwritten = all_tables.write_all(machine, folder)
    lines = dict([*captions(machine, drawn, tables), figure_elsewhere(plots_apis, three, folder), table_elsewhere(apis, three, folder),
                  table_elsewhere(opening, three, folder)])
    if "stress" not in lines:
        lines.update([table_elsewhere(stress, other, folder)])
    (output / "captions.tex").write_text("".join(f"\\definecaption{{{name}}}{{{text}}}\n" for name, text in lines.items()))
    progress.start("numbers")
    tex, names = (ROOT / "paper/paper.tex").read_text(), list(dict.fromkeys([*(made.name for made in drawn), *lines]))
    numbers = macros.collect(machine, [other], three)
    macros.check(tex, numbers, names)
    macros.write(numbers, tex, output / "numbers.tex", names)
    write_runs((machine, three), tex, names, output / "runs.tex")
    progress.end()
    for name, reason in left_out + unwritten:
        if name not in lines:
            print(f"  {name} is left out: {reason}")
    print(f"{machine.title}\n  {len(drawn)} figures, {len(tables)} tables, {len(macros.used_keys(tex, names))} numbers in the text, "
          "each from a recorded run")


def write_headline(machine):
    ratio_by_duration.draw_headline(machine).savefig(ROOT / "paper/headline.png", dpi=220, metadata={"Software": None})
    readme = ROOT / "README.md"
    three = Machine(DATA / APIS, whole=False)
    plots_apis.draw_headline(three).savefig(ROOT / "paper/apis.png", dpi=220, metadata={"Software": None})
    readme.write_text(headline.updated(readme.read_text(), machine, three))
    for page in docs_facts.PAGES:
        (ROOT / page).write_text(docs_facts.updated(page, (ROOT / page).read_text(), machine))


def draw_side_by_side(folders, output):
    """The page of these machines; log.txt names what was drawn, in how many seconds, and what each figure lacks."""
    output.mkdir(parents=True, exist_ok=True)
    with (output / "log.txt").open("w") as log:
        progress = Progress(log)
        reports = [recorded.taken(folder, output / folder.name, progress) if report.is_recorded(folder) else
                   report.make(Machine(folder), output / folder.name, progress) for folder in folders]
        index.write(output, reports)
    lines = [line.partition(":")[0] for made in reports for line in contents.left_out(made.left_out, made.compares_apis)]
    if lines:
        print(f"{'; '.join(lines)}. {output / 'log.txt'} says what each lacks.")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, nargs="+", help="folders of recorded runs")
    parser.add_argument("--headline", action="store_true", help="only the image and what README.md and docs/motion.md say of records")
    parser.add_argument("--output", type=Path, default=ROOT / "build/paper", help="where the files go")
    options = parser.parse_args()
    if options.headline:
        write_headline(Machine(DATA / MAIN))
    elif options.data:
        draw_side_by_side([folder.resolve() for folder in options.data], options.output)
    else:
        write_paper_inputs(options.output)


if __name__ == "__main__":
    try:
        main()
    except (Missing, sources.Unknown) as reason:
        sys.exit(f"figures: {reason}")
