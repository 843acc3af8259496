# SPDX-License-Identifier: MIT
"""Runs a search and gives its columns as arrays, by ASE's letters."""

from __future__ import annotations

import ctypes
import functools
from typing import Any, Dict, Tuple, Union

from . import _abi
from ._context import Context, context_of
from ._inputs import arrays
from ._library import lib
from ._problem import Search
from ._views import View

FIELDS = {"i": "first", "j": "second", "S": "shifts", "D": "vectors", "d": "distances", "offsets": "offsets"}
WANTED = {"S": _abi.SHIFTS, "D": _abi.VECTORS, "d": _abi.DISTANCES, "offsets": _abi.OFFSETS}
INDICES = {"int32": "i4", "int64": "i8"}
LIBRARYS_INDICES = "i4"


def index_code(index_dtype: Any) -> str:
    """Gives i4 or i8 from a name, or from a type of numpy's or torch's."""
    name = index_dtype if isinstance(index_dtype, str) else (
        getattr(index_dtype, "__name__", None) or getattr(index_dtype, "name", None) or str(index_dtype))
    code = INDICES.get(name.rpartition(".")[2])
    if code is None:
        raise ValueError(f"index_dtype is {index_dtype!r}: int32 or int64")
    return code


def letters(quantities: Any) -> str:
    """Raises ValueError unless the quantities are letters of "ijSdD"."""
    if not isinstance(quantities, str) or not quantities or quantities.strip("ijSdD"):
        raise ValueError(f"quantities is {quantities!r}: one or more of the letters i, j, S, d, D")
    return quantities


class List:
    """Owns a list that the library made."""

    def __init__(self, pointer: Any):
        self.pairs, self._pointer, self._free = pointer.contents, pointer, lib.sp_free

    def __del__(self) -> None:
        self._free(self._pointer)

    def column(self, letter: str) -> View:
        """Gives a view of the list's memory. It keeps the list."""
        given = getattr(self.pairs, FIELDS[letter])
        code = _abi.CODES[given.type]
        size = int(code[1:])
        wide = letter in "SD"
        shape = (given.rows, 3) if wide else (given.rows,)
        strides = (given.row_stride * size, given.column_stride * size) if wide else (given.row_stride * size,)
        return View(given.data or 0, shape, strides, code, True, self)


@functools.lru_cache(maxsize=256)
def _needed(names: Union[str, Tuple[str, ...]], sorts: bool) -> Tuple[Tuple[str, ...], int]:
    """Gives the columns to take from the library, and sp_list's flags for them. Sorted lists get offsets of their own."""
    needed = tuple(dict.fromkeys([*names, *("ij" if sorts else "")]))
    needed = tuple(name for name in needed if not (sorts and name == "offsets"))
    return needed, sum(WANTED.get(name, 0) for name in needed)


def columns(search: Search, names: Union[str, Tuple[str, ...]], backend: Union[str, Context], index_dtype: Any) -> Dict[str, Any]:
    """Gives the columns of the list by name: torch tensors if the positions are one."""
    code = index_code(index_dtype)
    sorts = search.queries.order is not None or search.points.order is not None
    needed, wanted = _needed(names, sorts)
    pointer = ctypes.POINTER(_abi.Pairs)()
    try:
        context_of(backend)._call(lib.sp_list, ctypes.byref(search.struct), wanted, ctypes.byref(pointer))
    except ValueError as failure:
        raise ValueError(search.translate(str(failure))) from None
    made = List(pointer)
    if search.cuda is not None:
        return {name: search.cuda.array(made.column(name), code if name in "ijS" else None) for name in names}
    found = {name: arrays.output(made.column(name)) for name in needed}
    if sorts:
        _regroup(search, found, "offsets" in names)
    if code != LIBRARYS_INDICES:
        found.update({name: arrays.cast(found[name], code) for name in found if name in "ijS"})
    if search.torch is not None:
        found = {name: to_torch(search.torch, column) for name, column in found.items()}
    return found


def _regroup(search: Search, found: Dict[str, Any], with_offsets: bool) -> None:
    """Maps a list of points that were sorted by system back to the caller's numbers, in place."""
    rest = [name for name in found if name not in "ij"]
    found["i"], found["j"], moved = arrays.regrouped([found[name] for name in rest], found["i"], found["j"],
                                                     search.queries.order, search.points.order)
    found.update(zip(rest, moved))
    if with_offsets:
        found["offsets"] = arrays.offsets(found["i"], search.rows)


def to_torch(torch: Any, column: Any) -> Any:
    """Gives a tensor that uses the column's memory."""
    if hasattr(column, "__array_interface__"):
        return torch.from_numpy(column)
    kinds = {"i": torch.int32, "q": torch.int64, "d": torch.float64}
    if not column.nbytes:
        return torch.empty(column.shape, dtype=kinds[column.format])
    return torch.frombuffer(column.cast("B"), dtype=kinds[column.format]).reshape(column.shape)
