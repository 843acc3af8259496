# SPDX-License-Identifier: MIT
"""Builds an sp_problem from the arguments of a search."""

from __future__ import annotations

import ctypes
import re
import sys
from typing import Any, Optional

from . import _abi, _inputs, _on_cuda
from ._systems import Sorted, sort
from ._views import View


def _atoms(positions: Any, cell: Any, pbc: Any) -> tuple:
    """Takes positions, cell and pbc from an ASE Atoms object. Arguments that are given win."""
    if not hasattr(positions, "get_positions"):
        return positions, cell, pbc
    return (positions.get_positions(), positions.cell if cell is None else cell,
            positions.pbc if pbc is None else pbc)


class Search:
    """A problem and the memory that it points to.

    rows: points, or queries, that i counts. points, queries: their systems.
    """

    def __init__(self, positions: Any, cutoff: Any = None, cell: Any = None, pbc: Any = None, *, radii: Any = None,
                 batch: Any = None, exclude: Any = None, half: bool = False, inclusive: bool = False,
                 self_pairs: bool = False, skin: Any = 0, queries: Any = None, query_radii: Any = None,
                 query_batch: Any = None):
        self.struct = _abi.Problem(size=ctypes.sizeof(_abi.Problem))
        self._keep: dict = {}
        self.torch = torch_of(positions)
        positions, cell, pbc = _atoms(positions, cell, pbc)
        self.cuda = self._cuda_of(positions, queries)
        points = self._points(positions, "positions")
        asked = None if queries is None else self._points(queries, "queries")
        self._put_boxes(*_inputs.boxes(_on_cuda.on_host(cell, "cell"), _on_cuda.on_host(pbc, "pbc")))
        self._set_systems(points, batch, asked, query_batch)
        self._set_points("positions", "radii", points, radii, self.points)
        if asked is not None:
            self._set_points("queries", "query_radii", asked, query_radii, self.queries)
        elif query_radii is not None:
            raise ValueError("query_radii are given, but there are no queries")
        self._set_lengths(cutoff, skin, radii)
        if exclude is not None:
            self._set_exclusions(_inputs.index_pairs(_on_cuda.on_host(exclude, "exclude"), "exclude"))
        self.struct.half, self.struct.inclusive, self.struct.self_pairs = map(int, map(bool, (half, inclusive, self_pairs)))
        self.rows = points.shape[0] if asked is None else asked.shape[0]

    def _cuda_of(self, positions: Any, queries: Any) -> Optional[_on_cuda.Library]:
        if not _on_cuda.is_on_cuda(positions):
            return None
        if queries is not None and not _on_cuda.is_on_cuda(queries):
            raise ValueError("queries are in the host's memory, the points in CUDA's: both must be in one")
        library = _on_cuda.Library(positions, _on_cuda.view(positions, "positions").cuda or 0)
        self.struct.stream = library.stream(positions)
        return library

    def _points(self, given: Any, name: str) -> View:
        if self.cuda is None:
            return _inputs.points(given, name)
        points = _on_cuda.view(given, name)
        if len(points.shape) != 2 or points.shape[1] != 3:
            raise ValueError(f"{name} has shape {points.shape}: N x 3 is needed")
        return points

    def _put(self, name: str, view: Optional[View]) -> None:
        if view is not None:
            setattr(self.struct, name, view.struct())
            self._keep[name] = view

    def _put_boxes(self, cells: Optional[View], flags: Optional[View]) -> None:
        self._put("boxes", cells)
        self._put("periodic", flags)
        self._boxes = 1 if cells is None else cells.shape[0]

    def _set_systems(self, points: View, batch: Any, asked: Optional[View], query_batch: Any) -> None:
        if asked is None and batch is None:
            self.points = self.queries = Sorted()
            return
        if asked is None:
            [self.points] = sort([_on_cuda.on_host(batch, "batch")], ["batch"], [points.shape[0]], self._boxes)
            self.queries = self.points
            return
        rows = [points.shape[0], asked.shape[0]]
        self.points, self.queries = sort([_on_cuda.on_host(batch, "batch"), _on_cuda.on_host(query_batch, "query_batch")],
                                         ["batch", "query_batch"], rows, self._boxes)
        self._put("query_offsets", self.queries.offsets)

    def _set_points(self, name: str, radii_name: str, points: View, radii: Any, systems: Sorted) -> None:
        of = _inputs.radii_of if self.cuda is None else self.cuda.radii
        sizes = None if radii is None else of(radii, radii_name, points.shape[0])
        if systems.order is not None and self.cuda is not None:
            raise ValueError("batch is not sorted: sort points in CUDA's memory by their systems")
        if systems.order is not None:
            points = _inputs.arrays.permuted(points, systems.order)
            sizes = sizes and _inputs.arrays.permuted(sizes, systems.order)
        self._put(name, points)
        self._put(radii_name, sizes)
        if name == "positions":
            self._put("offsets", systems.offsets)

    def set_positions(self, positions: Any) -> None:
        """Replaces the positions of a problem whose systems are sorted. Their number stays."""
        positions = _atoms(positions, 0, 0)[0]
        points = self._points(positions, "positions")
        if points.shape[0] != self.rows:
            raise ValueError(f"positions has {points.shape[0]} rows: the plan is for {self.rows} points")
        self._put("positions", points)
        if self.cuda is not None:
            self.struct.stream = self.cuda.stream(positions)

    def set_cell(self, cell: Any, pbc: Any) -> None:
        """Replaces the boxes. Their number stays."""
        cells, flags = _inputs.boxes(_on_cuda.on_host(cell, "cell"), _on_cuda.on_host(pbc, "pbc"))
        if cells is not None and cells.shape[0] != self._boxes:
            raise ValueError(f"cell has {cells.shape[0]} boxes: the plan is for {self._boxes}")
        self._put_boxes(cells, flags)

    def _set_lengths(self, cutoff: Any, skin: Any, radii: Any) -> None:
        if cutoff is None and radii is None:
            raise ValueError("neither a cutoff nor radii are given: give one of them")
        if hasattr(cutoff, "__len__") and not isinstance(cutoff, str):
            raise ValueError("cutoff is one number for all pairs: give the sizes of spheres as `radii`")
        self.struct.cutoff = 0.0 if cutoff is None else _inputs.number(cutoff, "cutoff")
        self.struct.skin = _inputs.number(skin, "skin")

    def _set_exclusions(self, pairs: View) -> None:
        if self.points.order is not None or self.queries.order is not None:
            pairs = _inputs.arrays.renumbered(pairs, self.queries.order, self.points.order)
        self._put("exclusions", pairs)

    def translate(self, message: str) -> str:
        """Replaces row numbers in the library's message by the caller's, where points were sorted by system."""
        for names, order in (("positions|radii", self.points.order), ("queries|query_radii", self.queries.order)):
            if order is not None:
                message = re.sub(rf"\b({names})\[(\d+)\]", lambda m: f"{m[1]}[{order[int(m[2])]}]", message)
        return message


def torch_of(positions: Any) -> Any:
    """Gives the torch module if it is loaded and the positions are one of its tensors."""
    torch = sys.modules.get("torch")
    tensor = getattr(torch, "Tensor", None)
    return torch if isinstance(tensor, type) and isinstance(positions, tensor) else None
