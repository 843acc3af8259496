# SPDX-License-Identifier: MIT
"""The stress catalogue as a table."""
from paper.numbers.stress import stressed
from paper.tables.tabular import Table
from paper.text import APIS

STRESS = ("The stress catalogue: what each row sets up, what was found, what had to hold, and on which backends "
          "it did. A figure without a name is that of every backend.")


def figure_text(figures):
    """One for all backends that found the same, else each with who found it."""
    owners = {}
    for backend, figure in figures.items():
        owners.setdefault(figure, []).append(backend)
    if len(owners) == 1:
        return next(iter(owners)) or "-"
    return "; ".join(f"{', '.join(APIS[name] for name in names)}: {figure}" for figure, names in owners.items())


def stress(machine):
    rows, last = [], None
    for test in stressed(machine):
        verdicts = [test.verdicts.get(name, test.verdicts.get("all", "-") if machine.has(name) else "-")
                    for name in ("cpu", "opengl", "cuda")]
        verdicts = ["-" if verdict == "skipped" else verdict for verdict in verdicts]
        first = test.row != last
        rows.append([str(test.row) if first else "", test.scene if first else "", test.what,
                     figure_text(test.figures), test.bound, *verdicts])
        last = test.row
    columns = ("r", *(f">{{\\raggedright\\arraybackslash}}p{{{width}mm}}" for width in (29, 25, 49, 25)), "l", "l", "l")
    heads = [[("", 1)] * 8, ["row", "scene", "what is tested", "figure", "bound", "CPU", "OpenGL", "CUDA"]]
    return Table("stress", STRESS, heads, rows, left=8, columns=columns, source=machine.source("stress.json")["id"],
                 long=True)
