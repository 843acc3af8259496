# SPDX-License-Identifier: MIT
"""Reads points and their box from files, through the packages that are installed."""

from __future__ import annotations

import importlib
import pathlib
from typing import Any, Callable, List, NamedTuple


class Points(NamedTuple):
    """The first frame of a file, in the file's unit of length. cell and pbc as for neighbor_list."""

    positions: Any
    cell: Any
    pbc: Any
    reader: str


class FileError(Exception):
    """No installed package can read the file."""


def _with_ase(path: str) -> Points:
    atoms = importlib.import_module("ase.io").read(path, index=0)
    return Points(atoms.get_positions(), atoms.cell, atoms.pbc, "ase")


def _with_mdanalysis(path: str) -> Points:
    universe = importlib.import_module("MDAnalysis").Universe(path)
    box = universe.trajectory.ts.triclinic_dimensions
    return Points(universe.atoms.positions, box, box is not None and [True] * 3, "MDAnalysis")


def _with_gsd(path: str) -> Points:
    with importlib.import_module("gsd.hoomd").open(path, "r") as trajectory:
        frame = trajectory[0]
    x, y, z, xy, xz, yz = (float(value) for value in frame.configuration.box)
    rows = [[x, 0.0, 0.0], [xy * y, y, 0.0], [xz * z, yz * z, z]]
    return Points(frame.particles.position, rows, [True, True, frame.configuration.dimensions != 2], "gsd")


def _with_meshio(path: str) -> Points:
    return Points(importlib.import_module("meshio").read(path).points, None, None, "meshio")


def _readers(path: str) -> List[Callable[[str], Points]]:
    """Lists the readers, the one for the file's format first."""
    if pathlib.Path(path).suffix == ".gsd":
        return [_with_gsd, _with_ase, _with_mdanalysis]
    return [_with_ase, _with_mdanalysis, _with_meshio]


def read(path: str) -> Points:
    """Reads the points of the first frame. Raises FileError if no package can, OSError if the file cannot be opened."""
    with open(path, "rb"):
        pass
    missing, failed = [], []
    for reader in _readers(path):
        try:
            return reader(path)
        except ModuleNotFoundError as error:
            missing.append((error.name or "").partition(".")[0])
        except (Exception, SystemExit) as error:  # a package may raise anything for a file of another format
            failed.append(f"{reader.__name__[6:]}: {type(error).__name__}: {error}")
    message = f"{path} cannot be read"
    if failed:
        message += " (" + "; ".join(failed) + ")"
    if missing:
        message += f": install {' or '.join(missing)}, for example with: python3 -m pip install {missing[0]}"
    raise FileError(message)
