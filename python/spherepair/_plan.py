# SPDX-License-Identifier: MIT
"""Plan: many lists of points that move, with memory that is allocated once."""

from __future__ import annotations

import ctypes
import operator
from typing import Any, Dict, Optional, Union

from . import _abi
from ._columns import FIELDS, index_code, letters, to_torch
from ._context import Context, context_of
from ._errors import CapacityError
from ._inputs import arrays
from ._library import lib
from ._problem import Search
from ._views import view

_SLACK = 1.25  # grown arrays get this many times the rows of the list, so that the next list fits, too


class Pairs:
    """A list of pairs in arrays that later lists overwrite.

    found: the number of pairs of the last list. capacity: the rows of the arrays.
    overflowed: found > capacity. Then the arrays hold no list, and reading them raises CapacityError.
    i, j, S, d, D: the columns of the plan's quantities, `found` rows each. offsets: (N + 1,), as csr has them.
    They are views: copy those that you keep beyond the next fill().
    """

    def __init__(self, columns: Dict[str, Any], capacity: int, torch: Any):
        self.found, self.capacity, self._columns, self._torch = 0, capacity, columns, torch
        self._struct = _abi.Pairs(size=ctypes.sizeof(_abi.Pairs))
        for name, column in columns.items():
            setattr(self._struct, FIELDS[name], view(column, name).struct())

    @property
    def overflowed(self) -> bool:
        return self.found > self.capacity

    def __getattr__(self, name: str) -> Any:
        if name not in FIELDS:
            raise AttributeError(f"Pairs has no {name!r}")
        if name not in self._columns:
            raise AttributeError(f"{name!r} is not among the quantities of the plan: make a plan with it")
        if self.overflowed:
            raise CapacityError(self.found, self.capacity)
        column = self._columns[name]
        column = column if name == "offsets" else column[:self.found]
        return column if self._torch is None else to_torch(self._torch, column)


class Plan:
    """A search that is done many times, for positions that change. Use it from one thread at a time.

    positions_like: (N, 3) or ASE Atoms: the number of points, and for ASE the cell and pbc.
    capacity: pairs that the arrays hold. None: the arrays grow when a list needs it.
    quantities: letters of "ijSdD", and "offsets" always.
    batch: as for neighbor_list, but sorted.
    The other arguments and the errors are those of neighbor_list. Leave the radii as they are while the plan lives.
    """

    def __init__(self, positions_like: Any, cutoff: Optional[float] = None, capacity: Optional[int] = None,
                 quantities: str = "ij", cell: Any = None, pbc: Any = None, *, radii: Any = None, batch: Any = None,
                 exclude: Any = None, half: bool = False, inclusive: bool = False, self_pairs: bool = False,
                 skin: float = 0, backend: Union[str, Context] = "auto", index_dtype: Any = "int32"):
        self._search = Search(positions_like, cutoff, cell, pbc, radii=radii, batch=batch, exclude=exclude, half=half,
                              inclusive=inclusive, self_pairs=self_pairs, skin=skin)
        if self._search.cuda is not None:
            raise ValueError("a plan is for positions in the host's memory: in CUDA's, call neighbor_list, or sp_fill from C")
        if self._search.points.order is not None:
            raise ValueError("batch is not sorted: sort the points of a plan by system")
        self._follows_atoms, self._pbc = cell is None, pbc
        self._names, self._code = letters(quantities), index_code(index_dtype)
        self._grows = capacity is None
        self.context: Context = context_of(backend)
        self._out = self.allocate(capacity or 0)

    def allocate(self, capacity: int) -> Pairs:
        """Allocates arrays for lists of up to `capacity` pairs, to be filled by fill(x, out)."""
        if operator.index(capacity) < 0:
            raise ValueError(f"capacity is {capacity}: it must not be negative")
        codes = {"d": "f8", "D": "f8"}
        columns = {name: arrays.new((capacity, 3) if name in "SD" else (capacity,), codes.get(name, self._code))
                   for name in self._names}
        columns["offsets"] = arrays.new((self._search.rows + 1,), "i8")
        return Pairs(columns, capacity, self._search.torch)

    def count(self, x: Any, cell: Any = None) -> int:
        """Counts the pairs. x: (N, 3), or Atoms. cell: the new cell, if it changed."""
        self._set(x, cell)
        found = ctypes.c_int64()
        self.context._call(lib.sp_count, ctypes.byref(self._search.struct), ctypes.byref(found))
        return found.value

    def fill(self, x: Any, out: Optional[Pairs] = None, cell: Any = None) -> Pairs:
        """Makes the list. x: (N, 3), or Atoms. cell: the new cell, if it changed.

        out: from allocate(); None: the plan's own arrays, which the next fill() overwrites.
        Returns `out`. If the arrays are too short, out.overflowed is set and out.found says how many rows are needed.
        The plan's own arrays grow instead, unless the plan has a capacity.
        """
        self._set(x, cell)
        if out is not None:
            if len(out._columns["offsets"]) != self._search.rows + 1:
                raise ValueError(f"out is for {len(out._columns['offsets']) - 1} points, the plan for {self._search.rows}")
            return self._fill(out)
        if self._fill(self._out).overflowed and self._grows:
            self._out = self.allocate(int(self._out.found * _SLACK))
            self._fill(self._out)
        return self._out

    def _set(self, x: Any, cell: Any) -> None:
        pbc = self._pbc
        if cell is None and self._follows_atoms and hasattr(x, "get_positions"):
            cell, pbc = x.cell, x.pbc if pbc is None else pbc
        self._search.set_positions(x)
        if cell is not None:
            self._search.set_cell(cell, pbc)

    def _fill(self, out: Pairs) -> Pairs:
        self.context._call(lib.sp_fill, ctypes.byref(self._search.struct), ctypes.byref(out._struct),
                           allowed=_abi.CAPACITY)
        out.found = out._struct.count
        return out
