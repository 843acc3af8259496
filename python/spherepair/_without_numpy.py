# SPDX-License-Identifier: MIT
"""Work on whole arrays without numpy, element by element. `_with_numpy` has the same functions."""

from __future__ import annotations

import bisect
import ctypes
import itertools
import math
import struct
from array import array
from typing import Any, Iterator, List, Optional, Sequence, Tuple

from ._views import View, contiguous, view

_LETTERS = {"f2": "e", "f4": "f", "f8": "d", "b1": "?", "i1": "b", "i2": "h", "i4": "i", "i8": "q", "u1": "B", "u2": "H",
            "u4": "I", "u8": "Q"}


def _elements(source: View) -> Iterator[Any]:
    """The numbers in C order."""
    letter = ("=" if source.native else ">") + _LETTERS[source.code]
    size = int(source.code[1:])
    for index in itertools.product(*map(range, source.shape)):
        address = source.address + sum(k * stride for k, stride in zip(index, source.strides))
        yield struct.unpack(letter, ctypes.string_at(address, size))[0]


def _stored(numbers: Any, shape: Tuple[int, ...], code: str) -> View:
    keep = array(_LETTERS[code], numbers)
    return View(keep.buffer_info()[0], shape, contiguous(shape, int(code[1:])), code, True, keep)


def converted(source: View, code: str) -> View:
    return _stored(map(float if code[0] == "f" else int, _elements(source)), source.shape, code)


def largest(source: View) -> int:
    return max(_elements(source), key=abs, default=0)


def padded(source: View) -> View:
    numbers, width = list(_elements(source)), source.shape[1]
    rows = (numbers[k * width:(k + 1) * width] + [0] * (3 - width) for k in range(source.shape[0]))
    return _stored(itertools.chain.from_iterable(rows), (source.shape[0], 3), "f8")


def diagonal(source: View) -> View:
    a, b, c = _elements(source)
    return _stored([a, 0, 0, 0, b, 0, 0, 0, c], (1, 9), "f8")


def permuted(source: View, order: Sequence[int]) -> View:
    numbers, width = list(_elements(source)), source.shape[1] if len(source.shape) > 1 else 1
    return _stored([numbers[row * width + k] for row in order for k in range(width)], source.shape, source.code)


def renumbered(pairs: View, first: Optional[Sequence[int]], second: Optional[Sequence[int]]) -> View:
    inverses = [{point: row for row, point in enumerate(order or ())} for order in (first, second)]
    numbers = [inverses[k % 2].get(number, number) for k, number in enumerate(_elements(pairs))]
    return _stored(numbers, pairs.shape, "i8")


def values(source: View) -> List[int]:
    return list(_elements(source))


def stable_order(systems: List[int]) -> Optional[List[int]]:
    order = sorted(range(len(systems)), key=systems.__getitem__)
    return None if order == list(range(len(systems))) else order


def gather(numbers: Any, order: Sequence[int]) -> List[Any]:
    return [numbers[k] for k in order]


def distinct(*several: List[int]) -> List[int]:
    return sorted(set().union(*several))


def starts(ordered: List[int], systems: Sequence[int]) -> View:
    found = [bisect.bisect_left(ordered, system) for system in systems] + [len(ordered)]
    return _stored(found, (len(found),), "i8")


def first_outside(systems: List[int], limit: int) -> Optional[int]:
    return next((k for k, system in enumerate(systems) if not 0 <= system < limit), None)


def new(shape: Tuple[int, ...], code: str) -> memoryview:
    """Allocates an array of zeros. A memoryview needs at least one row for a shape, so an empty one is a slice of it."""
    rows = max(shape[0], 1)
    size = int(code[1:]) * rows * math.prod(shape[1:])
    return memoryview(bytearray(size)).cast(_LETTERS[code], shape=(rows, *shape[1:]))[:shape[0]]


def output(source: View) -> memoryview:
    if 0 in source.shape:
        return new(source.shape, source.code)
    if source.strides != contiguous(source.shape, int(source.code[1:])):
        source = _stored(_elements(source), source.shape, source.code)
    size = source.shape[0] * source.strides[0]
    memory = (ctypes.c_char * size).from_address(source.address)
    memory.keep = source.keep
    return memoryview(memory).cast("B").cast(_LETTERS[source.code], shape=source.shape)


def cast(numbers: memoryview, code: str) -> memoryview:
    return output(converted(view(numbers, ""), code)) if numbers.format != _LETTERS[code] else numbers


def regrouped(columns: Sequence[memoryview], first: memoryview, second: memoryview, order: Optional[Sequence[int]],
              other: Optional[Sequence[int]]) -> Tuple[memoryview, memoryview, list]:
    i = first if order is None else [order[k] for k in first]
    j = second if other is None else [other[k] for k in second]
    rows = sorted(range(len(i)), key=i.__getitem__)
    i_code, j_code = view(first, "").code, view(second, "").code
    return (output(_stored([i[row] for row in rows], (len(rows),), i_code)),
            output(_stored([j[row] for row in rows], (len(rows),), j_code)),
            [output(permuted(view(column, ""), rows)) for column in columns])


def offsets(first: memoryview, rows: int) -> memoryview:
    found = [bisect.bisect_left(first, row) for row in range(rows + 1)]
    return output(_stored(found, (rows + 1,), "i8"))


def stacked(first: memoryview, second: memoryview, axis: int) -> memoryview:
    shape = (2, len(first)) if axis == 0 else (len(first), 2)
    if not len(first) and axis == 0:
        return memoryview((ctypes.c_int64 * 0 * 2)())  # casts give no such shape
    numbers = itertools.chain(first, second) if axis == 0 else itertools.chain.from_iterable(zip(first, second))
    return output(_stored(numbers, shape, view(first, "").code))
