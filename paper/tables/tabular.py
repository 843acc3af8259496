# SPDX-License-Identifier: MIT
"""A table of the paper, written as LaTeX and as text."""
import re
import textwrap
from dataclasses import dataclass, replace

from paper.text import escape, plain

WIDEST = 60  # characters of a cell in the text form


@dataclass
class Table:
    name: str
    caption: str
    heads: list  # two rows: groups as (text, columns), then one text a column
    rows: list
    left: int = 1  # number of first columns that are text, aligned left
    columns: tuple = ()  # of LaTeX, one per column, if not l and r
    source: str = ""  # id of the records, if not of the machine's main run
    long: bool = False  # may span pages


def power(mantissa, exponent):
    if not float(mantissa):
        return "0"
    return f"$10^{{{int(exponent)}}}$" if mantissa == "1" else f"${mantissa}\\cdot10^{{{int(exponent)}}}$"


MATHEMATICS = {  # what is set otherwise than typed
    r"(?<![\w.])(\d+)\^(-?\d+)": lambda m: f"${m[1]}^{{{m[2]}}}$",
    r"(?<![\w.])(-?\d[\d.]*)e([+-]?\d+)\b": lambda m: power(m[1], m[2]),
    r"(?<![\w.,-])\d[\d,]*-\d[\d,]*(?![\w.-])": lambda m: m[0].replace("-", "--"),
    r"(?<![\w.\-)\]^])-(?=\d[\d.]*(?![\d.]*e[+-]?\d))": lambda m: "$-$",
    r"\+-(?= )": lambda m: "$\\pm$",
    "†": lambda m: "\\rlap{\\textdagger}",
    "‡": lambda m: "\\rlap{\\textdaggerdbl}",
}


def typeset(cell):
    """Powers, floats and signs as mathematics: 10^6, 5.8e-05, +-."""
    found = [(m.start(), m.end(), made(m)) for pattern, made in MATHEMATICS.items() for m in re.finditer(pattern, cell)]
    text, at = "", 0
    for start, end, mathematics in sorted(found):
        text, at = text + escape(cell[at:start]) + mathematics, end
    return text + escape(cell[at:])


def as_tex(table):
    columns = "".join(table.columns or "l" * table.left + "r" * (len(table.heads[1]) - table.left))
    groups, rules, at = [], [], 1
    for text, width in table.heads[0]:
        groups.append(f"\\multicolumn{{{width}}}{{c}}{{{typeset(text)}}}")
        if text:
            rules.append(f"\\cmidrule(lr){{{at}-{at + width - 1}}}")
        at += width
    head = ["\\toprule"]
    if rules:
        head += [" & ".join(groups) + " \\\\", " ".join(rules)]
    head += [" & ".join(typeset(name) for name in table.heads[1]) + " \\\\", "\\midrule"]
    rows = [" & ".join(typeset(cell) for cell in row) + " \\\\" for row in table.rows]
    if table.long:
        start = [f"\\caption{{\\csname caption@{table.name}\\endcsname}}\\label{{tab:{table.name}}}\\\\"]
        lines = [*start, *head, "\\endfirsthead", *head, "\\endhead", *rows]
    else:
        lines = [*head, *rows]
    kind = "longtable" if table.long else "tabular"
    return "\n".join([f"\\begin{{{kind}}}{{@{{}}{columns}@{{}}}}", *lines, "\\bottomrule", f"\\end{{{kind}}}"]) + "\n"


def aligned(cells, widths, left):
    return "  ".join(cell.ljust(width) if k < left else cell.rjust(width)
                     for k, (cell, width) in enumerate(zip(cells, widths))).rstrip()


def broken(row):
    """A row as lines, with long cells wrapped."""
    parts = [textwrap.wrap(cell, WIDEST) or [""] for cell in row]
    height = max(map(len, parts))
    return [list(line) for line in zip(*(part + [""] * (height - len(part)) for part in parts))]


def as_text(table, title):
    rows = [line for row in table.rows for line in broken(row)]
    names = [table.heads[1], *rows]
    widths = [max(len(row[k]) for row in names) for k in range(len(table.heads[1]))]
    groups, at = [], 0
    for text, count in table.heads[0]:
        room = sum(widths[at:at + count]) + 2 * (count - 1)
        widths[at + count - 1] += max(0, len(text) - room)
        groups.append(text.center(max(room, len(text)), "-" if text else " "))
        at += count
    lines = [aligned(row, widths, table.left) for row in names]
    head = ["  ".join(groups).rstrip()] if any(text for text, _ in table.heads[0]) else []
    return "\n".join([plain(table.caption), title, "", *head, lines[0], "-" * max(map(len, lines)), *lines[1:]]) + "\n"


def without_empty_columns(table):
    """Drops columns without values, as of a machine without a GPU."""
    keep = [any(row[k] != "-" for row in table.rows) for k in range(len(table.heads[1]))]
    groups, at = [], 0
    for text, count in table.heads[0]:
        groups.append((text, sum(keep[at:at + count])))
        at += count

    def thin(row):
        return [cell for cell, kept in zip(row, keep) if kept]

    heads = [[(text, count) for text, count in groups if count], thin(table.heads[1])]
    return replace(table, heads=heads, rows=[thin(row) for row in table.rows], columns=tuple(thin(table.columns)))
