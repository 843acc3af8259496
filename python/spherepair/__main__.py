# SPDX-License-Identifier: MIT
"""python -m spherepair pairs FILE --cutoff R [--output OUT.npz]"""

from __future__ import annotations

import argparse
import sys
from typing import Any, List, Optional

from . import BackendError, __version__, _columns, _context, _files
from ._problem import Search


def _arguments() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m spherepair", description="Finds pairs of points, exactly.")
    parser.add_argument("--version", action="version", version=f"spherepair {__version__}")
    pairs = parser.add_subparsers(dest="command", required=True).add_parser(
        "pairs", help="list the pairs of a file's points within a cutoff",
        description="Lists the pairs of the first frame's points at a distance below the cutoff, each pair once. "
                    "Reads what ASE, MDAnalysis, gsd or meshio can read, with the periodic box of the file.")
    pairs.add_argument("file", metavar="FILE")
    pairs.add_argument("--cutoff", type=float, required=True, metavar="R", help="in the file's unit of length")
    pairs.add_argument("--output", metavar="OUT.npz", help="write i, j, S and d, as numpy arrays")
    pairs.add_argument("--backend", default="auto", help="cpu, opengl, cuda, vulkan or auto (default)")
    return parser


def _box(points: _files.Points) -> str:
    if points.cell is None or not any(points.pbc):
        return "open"
    rows = "; ".join(" ".join(f"{float(value):g}" for value in row) for row in points.cell)
    return f"{rows}, periodic along {' '.join(letter for letter, flag in zip('abc', points.pbc) if flag)}"


def _summary(path: str, points: _files.Points, device: str, found: dict, cutoff: float) -> str:
    i, j, d = found["i"], found["j"], found["d"]
    count = len(points.positions)
    lines = [("file", f"{path}, read with {points.reader}"), ("points", str(count)), ("box", _box(points)),
             ("cutoff", f"{cutoff:g}"), ("pairs", str(len(i)))]
    if len(i):
        neighbours = [0] * count
        for index in (*i.tolist(), *j.tolist()):
            neighbours[index] += 1
        lines += [("distances", f"{min(d):.10g} to {max(d):.10g}"),
                  ("neighbours", f"{min(neighbours)} to {max(neighbours)}, {2 * len(i) / count:.4g} on average")]
    lines += [("backend", device)]
    return "\n".join(f"{name:<11} {text}" for name, text in lines)


def _pairs(options: argparse.Namespace) -> None:
    points = _files.read(options.file)
    context = _context.context_of(options.backend)
    search = Search(points.positions, options.cutoff, points.cell, points.pbc, half=True)
    found = _columns.columns(search, "ijSd", context, "int32")
    if options.output:
        import numpy  # the packages that read files need numpy

        with open(options.output, "wb") as file:
            numpy.savez(file, **found)
    print(_summary(options.file, points, f"{context.backend}: {context.device}", found, options.cutoff))


def main(words: Optional[List[str]] = None) -> Any:
    """Runs the command. Returns the exit status: 0, or 1 after a message."""
    options = _arguments().parse_args(words)
    try:
        _pairs(options)
    except (OSError, ValueError, MemoryError, BackendError, _files.FileError, ImportError) as error:
        print(f"spherepair: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
