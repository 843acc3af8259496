# SPDX-License-Identifier: MIT
"""Work on whole arrays with numpy. `_without_numpy` has the same functions."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np

from ._views import View, view


def converted(source: View, code: str) -> View:
    """Copies into C order, as numbers of type `code`."""
    return view(np.array(np.asarray(source), dtype=code, order="C"), "")


def largest(source: View) -> int:
    """Finds the integer of the largest magnitude, with its sign."""
    numbers = np.asarray(source).reshape(-1)
    return max(int(numbers.max()), int(numbers.min()), key=abs) if numbers.size else 0


def padded(source: View) -> View:
    """Appends columns of zeros to N x 1 or N x 2 numbers: N x 3."""
    numbers = np.asarray(source)
    wide = np.zeros((len(numbers), 3), numbers.dtype)
    wide[:, :numbers.shape[1]] = numbers
    return view(wide, "")


def diagonal(source: View) -> View:
    """Makes the 1 x 9 numbers of a matrix with these three on its diagonal."""
    matrix = np.zeros((1, 9))
    matrix[0, ::4] = np.asarray(source)
    return view(matrix, "")


def permuted(source: View, order: Any) -> View:
    """Takes row order[k] of the source as row k."""
    return view(np.asarray(source)[order], "")


def renumbered(pairs: View, first: Optional[Any], second: Optional[Any]) -> View:
    """Maps N x 2 indices, each column through the inverse of its order. Indices out of range stay."""
    result = np.array(np.asarray(pairs), dtype=np.int64)
    for column, order in enumerate((first, second)):
        if order is not None and len(order):
            inverse = np.empty(len(order), np.int64)
            inverse[order] = np.arange(len(order))
            inside = (result[:, column] >= 0) & (result[:, column] < len(order))
            result[inside, column] = inverse[result[inside, column]]
    return view(result, "")


def values(source: View) -> Any:
    """Gives integers as int64 that can be indexed."""
    return np.asarray(source).astype(np.int64, copy=False)


def stable_order(systems: Any) -> Optional[Any]:
    """Finds the order that sorts the numbers, None if they are sorted. Equal numbers keep their order."""
    return None if np.all(systems[1:] >= systems[:-1]) else np.argsort(systems, kind="stable")


def gather(numbers: Any, order: Any) -> Any:
    return numbers[order]


def distinct(*several: Any) -> Any:
    """Lists the numbers that occur, ascending."""
    return np.unique(np.concatenate(several))


def starts(ordered: Any, systems: Sequence[int]) -> View:
    """Finds where each system starts among the sorted numbers, and appends the number of numbers."""
    found = np.searchsorted(ordered, np.asarray(systems, np.int64))
    return view(np.append(found, len(ordered)).astype(np.int64), "")


def first_outside(systems: Any, limit: int) -> Optional[int]:
    """Finds the index of the first number below 0 or not below the limit."""
    outside = np.flatnonzero((systems < 0) | (systems >= limit))
    return int(outside[0]) if len(outside) else None


def new(shape: Tuple[int, ...], code: str) -> Any:
    """Allocates an array of zeros."""
    return np.zeros(shape, code)


def output(source: View) -> Any:
    """Gives the array for the caller, which uses the source's memory."""
    return np.asarray(source)


def cast(numbers: Any, code: str) -> Any:
    """Converts the numbers to `code`, in C order."""
    return np.ascontiguousarray(numbers, code)


def regrouped(columns: Sequence[Any], first: Any, second: Any, order: Any, other: Any) -> Tuple[Any, Any, list]:
    """Maps i through `order` and j through `other`, and sorts the rows by i. Gives i, j and the columns."""
    i = first if order is None else order[first]
    j = second if other is None else other[second]
    rows = np.argsort(i, kind="stable")
    return i[rows].astype(first.dtype), j[rows].astype(second.dtype), [column[rows] for column in columns]


def offsets(first: Any, rows: int) -> Any:
    """Finds where the pairs of each point start in a list that is sorted by i: rows + 1 numbers."""
    return np.searchsorted(first, np.arange(rows + 1)).astype(np.int64)


def stacked(first: Any, second: Any, axis: int) -> Any:
    """Joins two columns as the rows (axis 0) or the columns (axis 1) of one array."""
    return np.stack((first, second), axis)
