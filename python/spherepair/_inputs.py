# SPDX-License-Identifier: MIT
"""Turns arguments into the library's inputs: numbers, points, radii, boxes, indices."""

from __future__ import annotations

import math
from array import array
from typing import Any, List, Optional, Tuple

from ._views import View, contiguous, numpy, refuse_device_memory, view

if numpy is not None:
    from . import _with_numpy as arrays
else:
    from . import _without_numpy as arrays  # type: ignore[no-redef]

LARGEST = 2**53  # float64 holds every integer up to it


def number(value: Any, name: str) -> float:
    """Gives the float64 that is equal to the value."""
    try:
        result = math.nan if isinstance(value, (str, bytes)) else float(value)
        if result == value or value != value:
            return result
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"{name} is {value!r}: it is no number, or float64 cannot hold it")


def floats(obj: Any, name: str) -> View:
    """Gives a view of float32 or float64; other numbers become float64 if that changes no value."""
    given = view(obj, name)
    if given.usable(("f4", "f8")):
        return given
    if given.code not in ("f2", "f4", "f8") and given.code[0] not in "iu":
        raise ValueError(f"{name} has elements of type {_type_of(obj, given)}: give float64 or float32")
    if given.code in ("i8", "u8") and abs(arrays.largest(given)) > LARGEST:
        raise ValueError(f"{name} has the integer {arrays.largest(given)}: float64 holds integers up to 2**53")
    return arrays.converted(given, "f8")


def integers(obj: Any, name: str) -> View:
    """Gives a view of int32 or int64; other integers become int64."""
    given = view(obj, name)
    if given.usable(("i4", "i8")):
        return given
    if 0 in given.shape:
        return View(given.address, given.shape, contiguous(given.shape, 8), "i8", True, given.keep)
    if given.code[0] not in "iu":
        raise ValueError(f"{name} has elements of type {_type_of(obj, given)}: give int64 or int32")
    if given.code == "u8" and arrays.largest(given) >= 2**63:
        raise ValueError(f"{name} has the integer {arrays.largest(given)}: it is beyond 64 bits with a sign")
    return arrays.converted(given, "i8")


def _type_of(obj: Any, given: View) -> str:
    return str(getattr(obj, "dtype", given.code))


def points(obj: Any, name: str) -> View:
    """Reads N x 3 coordinates."""
    given = floats(obj, name)
    if given.shape == (0,):
        return View(0, (0, 3), (24, 8), "f8", True, None)
    if len(given.shape) != 2 or given.shape[1] != 3:
        raise ValueError(f"{name} has shape {given.shape}: N x 3 is needed")
    return given


def padded_points(obj: Any, name: str) -> View:
    """Makes N x 3 coordinates from N, N x 1, N x 2 or N x 3: zeros fill the row."""
    given = floats(obj, name)
    if len(given.shape) == 1 and given.shape != (0,):
        given = View(given.address, (*given.shape, 1), (*given.strides, int(given.code[1:])), *given[3:])
    if len(given.shape) == 2 and given.shape[1] in (1, 2):
        given = arrays.padded(given)
    return points(given, name)


def radii_of(obj: Any, name: str, rows: int) -> View:
    """Reads N radii; one number is the radius of all."""
    refuse_device_memory(obj, name)
    if not hasattr(obj, "__len__") or getattr(obj, "shape", None) == ():
        obj = [number(obj, name)]
        same = floats(obj, name)
        return View(same.address, (rows,), (0,), same.code, True, same.keep)
    given = floats(obj, name)
    if given.shape != (rows,):
        raise ValueError(f"{name} has shape {given.shape}: one radius for each of {rows} points is needed")
    return given


def index_pairs(obj: Any, name: str) -> View:
    """Reads E x 2 indices."""
    given = integers(obj, name)
    if given.shape == (0,):
        return View(0, (0, 2), (16, 8), "i8", True, None)
    if len(given.shape) != 2 or given.shape[1] != 2:
        raise ValueError(f"{name} has shape {given.shape}: E x 2 indices are needed")
    return given


def _cells(cell: Any) -> View:
    """Makes B x 9 numbers from three lengths, 3 x 3 rows or B x 3 x 3 rows."""
    given = floats(cell, "cell")
    if given.shape == (3,):
        return arrays.diagonal(given)
    if given.shape[-2:] != (3, 3) or len(given.shape) > 3:
        raise ValueError(f"cell has shape {given.shape}: 3 lengths, 3 x 3 rows or B x 3 x 3 rows are needed")
    shape = (given.shape[0] if len(given.shape) == 3 else 1, 9)
    copy = given.copied(shape)
    return copy if copy is not None else arrays.converted(given, "f8").copied(shape)


def _flags(pbc: Any) -> List[List[int]]:
    """Makes B x 3 of 0 and 1 from one flag, three, or B x 3."""
    rows = pbc.tolist() if hasattr(pbc, "tolist") else pbc
    if not hasattr(rows, "__len__"):
        rows = [rows] * 3
    if len(rows) and not hasattr(rows[0], "__len__"):
        rows = [rows]
    for index, row in enumerate(rows):
        if not hasattr(row, "__len__") or isinstance(row, str) or len(row) != 3 or any(flag not in (0, 1) for flag in row):
            raise ValueError(f"pbc[{index}] is {row!r}: three flags are needed, one for each row of the cell")
    return [[int(flag) for flag in row] for row in rows]


def flags(pbc: Any) -> List[int]:
    """Makes three flags of one box."""
    rows = _flags(pbc)
    if len(rows) != 1:
        raise ValueError(f"pbc has {len(rows)} rows, but there is one box: give three flags")
    return rows[0]


def _bytes(rows: List[List[int]]) -> View:
    """Makes B x 3 bytes."""
    keep = array("B", [flag for row in rows for flag in row])
    return View(keep.buffer_info()[0], (len(rows), 3), (3, 1), "u1", True, keep)


_PERIODIC = [[1, 1, 1]]  # the flags of one box, and their bytes
_periodic_bytes = _bytes(_PERIODIC)


def boxes(cell: Any, pbc: Any) -> Tuple[Optional[View], Optional[View]]:
    """Makes B x 9 rows of the boxes and B x 3 flags, or None and None for open boxes. Without pbc a cell is periodic."""
    if cell is None:
        if pbc is not None and any(map(any, _flags(pbc))):
            raise ValueError("pbc is set, but there is no cell: give its rows as `cell`")
        return None, None
    cells = _cells(cell)
    flags = _PERIODIC if pbc is None or pbc is True else _flags(pbc)
    count = max(cells.shape[0], len(flags))
    if {cells.shape[0], len(flags)} - {1, count}:
        raise ValueError(f"cell has {cells.shape[0]} boxes, pbc has {len(flags)} rows: one of them, or equally many")
    if cells.shape[0] < count:
        cells = arrays.permuted(cells, [0] * count)
        cells = View(cells.address, (count, 9), (72, 8), "f8", True, cells.keep)
    if len(flags) < count:
        flags = flags * count
    return cells, _periodic_bytes if flags is _PERIODIC else _bytes(flags)
