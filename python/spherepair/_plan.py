# SPDX-License-Identifier: MIT
"""Plan: many lists of points that move, with memory that is allocated once."""

from __future__ import annotations

import ctypes
import operator
from typing import Any, Dict, Optional, Union

from . import _abi, _on_cuda
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
    columns: the whole arrays by these names, `capacity` rows each.

    In CUDA's memory `columns` also has "found", one int64, unless the plan's arrays grow. `found`, and with it `overflowed`
    and i, j, S, d, D, offsets, then wait until the list is made; `columns` does not wait. Reading `found` raises ValueError if
    the last list's positions had a number that cannot be listed.
    """

    def __init__(self, columns: Dict[str, Any], search: Search):
        self._columns, self._torch, self._count = columns, None if search.cuda else search.torch, 0
        self._views = {name: _on_cuda.view(column, name, ("i8", "i4", "f8")) if search.cuda else view(column, name)
                       for name, column in columns.items()}
        self.capacity: int = min(given.shape[0] for name, given in self._views.items() if name in "ijSdD")
        self._struct = _abi.Pairs(size=ctypes.sizeof(_abi.Pairs))
        for name, given in self._views.items():
            setattr(self._struct, FIELDS.get(name, name), given.struct())

    @property
    def columns(self) -> Dict[str, Any]:
        return {name: column if self._torch is None else to_torch(self._torch, column)
                for name, column in self._columns.items()}

    @property
    def found(self) -> int:
        found = int(self._columns["found"][0]) if "found" in self._columns else self._count
        if found == -2**63:
            raise ValueError("the reach spans too many boxes of the cell: count() them, which says what to do")
        if found < 0:
            raise ValueError(f"positions[{-1 - found}] cannot be listed: count() them, which names the number")
        return found

    @property
    def overflowed(self) -> bool:
        return self.found > self.capacity

    def __getattr__(self, name: str) -> Any:
        if name not in FIELDS:
            raise AttributeError(f"Pairs has no {name!r}")
        if name not in self._columns:
            raise AttributeError(f"{name!r} is not among the quantities of the plan: make a plan with it")
        found = self.found
        if found > self.capacity:
            raise CapacityError(found, self.capacity)
        column = self._columns[name]
        column = column if name == "offsets" else column[:found]
        return column if self._torch is None else to_torch(self._torch, column)


class Plan:
    """A search that is done many times, for positions that change. Use it from one thread at a time.

    positions_like: (N, 3) or ASE Atoms: the number of points, and for ASE the cell and pbc. In CUDA's memory all positions
        and columns of the plan are there.
    capacity: pairs that the arrays hold. None: the arrays grow when a list needs it.
    quantities: letters of "ijSdD", and "offsets" always.
    batch: as for neighbor_list, but sorted.
    backend: a name or a Context. In CUDA's memory a plan opens a context of its own for a name.
    The other arguments and the errors are those of neighbor_list. Leave the radii as they are while the plan lives.
    """

    def __init__(self, positions_like: Any, cutoff: Optional[float] = None, capacity: Optional[int] = None,
                 quantities: str = "ij", cell: Any = None, pbc: Any = None, *, radii: Any = None, batch: Any = None,
                 exclude: Any = None, half: bool = False, inclusive: bool = False, self_pairs: bool = False,
                 skin: float = 0, backend: Union[str, Context] = "auto", index_dtype: Any = "int32"):
        self._search = Search(positions_like, cutoff, cell, pbc, radii=radii, batch=batch, exclude=exclude, half=half,
                              inclusive=inclusive, self_pairs=self_pairs, skin=skin)
        if self._search.points.order is not None:
            raise ValueError("batch is not sorted: sort the points of a plan by system")
        self._follows_atoms, self._pbc = cell is None, pbc
        self._names, self._code = letters(quantities), index_code(index_dtype)
        self._grows, cuda = capacity is None, self._search.cuda
        # A list of another problem would change the buffers that a graph uses.
        self.context: Context = Context(backend) if cuda and isinstance(backend, str) else context_of(backend)
        makes_arrays = not cuda or cuda.torch or cuda.cupy
        self._out = self._allocate(0 if capacity is None else capacity, not self._grows) if makes_arrays else None

    def allocate(self, capacity: int) -> Pairs:
        """Allocates arrays for lists of up to `capacity` pairs, to be filled by fill(x, out)."""
        return self._allocate(capacity, True)

    def _allocate(self, capacity: int, with_found: bool) -> Pairs:
        try:
            capacity = operator.index(capacity)
        except TypeError:
            raise ValueError(f"capacity is {capacity!r}: a number of pairs is needed") from None
        if capacity < 0:
            raise ValueError(f"capacity is {capacity}: it must not be negative")
        new = self._search.cuda.new if self._search.cuda else arrays.new
        codes = {"d": "f8", "D": "f8"}
        columns = {name: new((capacity, 3) if name in "SD" else (capacity,), codes.get(name, self._code))
                   for name in self._names}
        columns["offsets"] = new((self._search.rows + 1,), "i8")
        if self._search.cuda and with_found:
            columns["found"] = new((1,), "i8")
        return Pairs(columns, self._search)

    def into(self, **columns: Any) -> Pairs:
        """Takes arrays of the caller's, to be filled by fill(x, out): into(i=..., j=..., ...).

        i, j: (P,), S: (P, 3), int32 or int64. d: (P,), D: (P, 3) float64. offsets: (N + 1,) int64; it may be left out.
        found: (1,) int64, in CUDA's memory: gets the number of pairs. Without it fill() waits for the number.
        The capacity is the P of the shortest.
        """
        known = {*self._names, "offsets"} | ({"found"} if self._search.cuda else set())
        if set(columns) - known or set(self._names) - set(columns):
            raise ValueError(f"the columns are {', '.join(columns)}: give {', '.join(self._names)}, and if you like "
                             f"{' or '.join(sorted(known - set(self._names)))}")
        return Pairs(columns, self._search)

    def count(self, x: Any, cell: Any = None) -> int:
        """Counts the pairs. x: (N, 3), or Atoms. cell: the new cell, if it changed."""
        self._set(x, cell)
        found = ctypes.c_int64()
        self.context._call(lib.sp_count, ctypes.byref(self._search.struct), ctypes.byref(found))
        return found.value

    def fill(self, x: Any, out: Optional[Pairs] = None, cell: Any = None) -> Pairs:
        """Makes the list. x: (N, 3), or Atoms. cell: the new cell, if it changed.

        out: from allocate() or into(); None: the plan's own arrays, which the next fill() overwrites.
        Returns `out`. If the arrays are too short, out.overflowed is set and out.found says how many rows are needed.
        The plan's own arrays grow instead, unless the plan has a capacity.

        In CUDA's memory the list is made in the current stream. The first fill allocates and waits. Later ones do neither and
        can be captured into a CUDA graph, if `out` has as many rows and "found", and the cell is the same. A graph stays
        valid while the plan and `out` live, until a fill with another cell or number of rows.
        """
        self._set(x, cell)
        if out is not None:
            offsets = out._views.get("offsets")
            if offsets is not None and offsets.shape[0] != self._search.rows + 1:
                raise ValueError(f"out is for {offsets.shape[0] - 1} points, the plan for {self._search.rows}")
            return self._fill(out)
        if self._out is None:
            raise ValueError("the plan has no arrays of its own in CUDA's memory without torch or cupy: give `out`")
        if not self._grows:
            return self._fill(self._out)
        if self._fill(self._out).overflowed:
            self._out = self._allocate(int(self._out.found * _SLACK), False)
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
        try:
            self.context._call(lib.sp_fill, ctypes.byref(self._search.struct), ctypes.byref(out._struct),
                               allowed=_abi.CAPACITY)
        except ValueError as failure:
            if "cannot be captured" not in str(failure):
                raise
            raise ValueError("this fill cannot be captured: give the plan a capacity, or `out` a column `found`, and fill "
                             "once before with the same cell and as many rows") from None
        out._count = out._struct.count
        return out
