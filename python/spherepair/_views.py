# SPDX-License-Identifier: MIT
"""Reads the arrays that callers give, without a copy where their numbers are float32, float64, int32 or int64."""

from __future__ import annotations

import array
import ctypes
import functools
import math
import struct
import sys
from collections import abc
from numbers import Integral
from typing import Any, NamedTuple, Optional, Tuple

from . import _abi, _dlpack

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

_ORDER = "<" if sys.byteorder == "little" else ">"
_KINDS = {"?": "b", **dict.fromkeys("bhilqn", "i"), **dict.fromkeys("BHILQN", "u"), **dict.fromkeys("efd", "f")}
_nothing = ctypes.create_string_buffer(8)  # the memory of an array without elements


class View(NamedTuple):
    """Numbers in the host's memory, or in CUDA's. `keep` is the object that owns them."""

    address: int
    shape: Tuple[int, ...]
    strides: Tuple[int, ...]  # in bytes
    code: str  # kind and size in bytes: f8, i4, ...
    native: bool  # whether the order of the bytes is this machine's
    keep: Any
    cuda: Optional[int] = None  # the number of the CUDA device; None: the host

    @property
    def __array_interface__(self) -> dict:
        order = _ORDER if self.native else "><"[_ORDER == ">"]
        return {"version": 3, "shape": self.shape, "typestr": order + self.code, "strides": self.strides,
                "data": (self.address or ctypes.addressof(_nothing), False)}

    def usable(self, codes: Tuple[str, ...]) -> bool:
        """Says whether the library can read the numbers where they are."""
        size = int(self.code[1:])
        return self.code in codes and self.native and not any([number % size for number in (self.address, *self.strides)])

    def copied(self, shape: Tuple[int, ...]) -> Optional["View"]:
        """Gives a copy of float64 numbers in C order, with another shape. None for other numbers."""
        if self.code != "f8" or not self.native or self.strides != contiguous(self.shape, 8):
            return None
        keep = array.array("d", ctypes.string_at(self.address, 8 * math.prod(shape)))
        return View(keep.buffer_info()[0], shape, contiguous(shape, 8), "f8", True, keep)

    def struct(self) -> _abi.Array:
        """Gives the view as an sp_array. Its code must be one of _abi.TYPES."""
        size = int(self.code[1:])
        rows, columns = (*self.shape, 1)[:2]
        row_stride, column_stride = (*self.strides, size)[:2]
        address = self.address if rows and columns else ctypes.addressof(_nothing)
        device, number = (_abi.HOST, 0) if self.cuda is None else (_abi.CUDA, self.cuda)
        return _abi.Array(address, rows, columns, row_stride // size, column_stride // size, _abi.TYPES[self.code], device, number)


@functools.lru_cache(maxsize=1024)
def contiguous(shape: Tuple[int, ...], size: int) -> Tuple[int, ...]:
    """Gives the strides in bytes of an array in C order."""
    strides = [size]
    for length in reversed(shape[1:]):
        strides.insert(0, strides[0] * length)
    return tuple(strides[:len(shape)])


def view(obj: Any, name: str) -> View:
    """Gives a view of any array of numbers. Nested sequences are copied. `name` is for messages."""
    if numpy is not None and type(obj) is numpy.ndarray:  # on the host, and without a gradient
        return _of_interface(obj, obj.__array_interface__, name)
    refuse_device_memory(obj, name)
    if getattr(obj, "requires_grad", False):
        obj = obj.detach()
    interface = getattr(obj, "__array_interface__", None)
    if isinstance(interface, dict) and isinstance(interface.get("data"), tuple):
        return _of_interface(obj, interface, name)
    if hasattr(obj, "__dlpack__"):
        return View(*_dlpack.read(obj, name))
    buffer = _buffer(obj)
    if numpy is not None and (buffer is not None or hasattr(obj, "__array__")):
        return view(numpy.asarray(obj if buffer is None else buffer), name)
    if buffer is not None:
        return _of_buffer(buffer, name)
    if isinstance(obj, abc.Sequence) and not isinstance(obj, (str, bytes)):
        return _of_sequence(obj, name)
    raise ValueError(f"{name} is of type {type(obj).__name__}: give an array, or nested lists of numbers")


def refuse_device_memory(obj: Any, name: str) -> None:
    """Raises ValueError for an array that the host cannot read."""
    device = getattr(obj, "__dlpack_device__", None)
    if hasattr(obj, "__cuda_array_interface__") or (callable(device) and device()[0] not in _dlpack.HOST_DEVICES):
        raise ValueError(f"{name} is in a device's memory, where it is not read; copy the array to the host first")


def _of_interface(obj: Any, interface: dict, name: str) -> View:
    if numpy is not None and isinstance(obj, numpy.ma.MaskedArray) and numpy.ma.is_masked(obj):
        raise ValueError(f"{name} has masked elements: fill or remove them")
    order, kind, size = interface["typestr"][0], interface["typestr"][1], int(interface["typestr"][2:] or 0)
    if kind not in "fiub" or size > 8:
        found = getattr(obj, "dtype", interface["typestr"])
        raise ValueError(f"{name} has elements of type {found}: give float64 or float32")
    shape = tuple(interface["shape"])
    strides = interface.get("strides") or contiguous(shape, size)
    return View(interface["data"][0], shape, tuple(strides), f"{kind}{size}", order in (_ORDER, "|", "="), obj)


def _buffer(obj: Any) -> Optional[memoryview]:
    try:
        return memoryview(obj)
    except TypeError:
        return None


def _of_buffer(buffer: memoryview, name: str) -> View:
    """Reads a buffer without numpy. Memory that is read-only or not contiguous is copied."""
    order, letter = buffer.format[:-1], buffer.format[-1:]
    if letter not in _KINDS or len(order) > 1:
        raise ValueError(f"{name} has elements of type {buffer.format!r}: give float64 or float32")
    if buffer.readonly or not buffer.c_contiguous:
        shape, keep = buffer.shape, bytearray(buffer.tobytes())
    else:
        shape, keep = buffer.shape, buffer.cast("B") if buffer.nbytes else bytearray()
    size = struct.calcsize((order or "@") + letter)
    address = ctypes.addressof(ctypes.c_char.from_buffer(keep)) if len(keep) else 0
    native = order in ("", "@", "=", _ORDER)
    return View(address, tuple(shape), contiguous(tuple(shape), size), f"{_KINDS[letter]}{size}", native, keep)


def _length(obj: Any) -> Optional[int]:
    """Gives the number of elements, or None for a number."""
    try:
        return None if isinstance(obj, (str, bytes)) else len(obj)
    except TypeError:
        return None


def _place(name: str, index: int, shape: Tuple[int, ...]) -> str:
    """Names an element by its number in C order: positions[3][0]."""
    digits = []
    for length in reversed(shape):
        index, digit = divmod(index, length)
        digits.insert(0, f"[{digit}]")
    return name + "".join(digits)


def _of_sequence(values: abc.Sequence, name: str) -> View:
    """Copies nested sequences into int64, if all are integers, or float64."""
    shape: Tuple[int, ...] = (len(values),)
    while values and _length(values[0]) is not None:
        inner = _length(values[0])
        for index, row in enumerate(values):
            if _length(row) != inner:
                found = "is a number" if _length(row) is None else f"has {_length(row)} elements"
                raise ValueError(f"{_place(name, index, shape)} {found}, the rows before have {inner}")
        shape += (inner,)
        values = [value for row in values for value in row]
    kinds = set(map(type, values))
    letter = "q" if all(issubclass(kind, Integral) for kind in kinds) else "d"
    if not all(issubclass(kind, float) for kind in kinds):
        _check_elements(values, name, shape, letter)
    numbers = array.array(letter, values)
    code = "i8" if letter == "q" else "f8"
    return View(numbers.buffer_info()[0], shape, contiguous(shape, 8), code, True, numbers)


def _check_elements(values: abc.Sequence, name: str, shape: Tuple[int, ...], letter: str) -> None:
    """Raises ValueError at the first element that is no number, or that float64 or int64 would round."""
    for index, value in enumerate(values):
        if isinstance(value, float):
            continue
        try:
            held = not isinstance(value, str) and (-2**63 <= value < 2**63 if letter == "q" else
                                                  float(value) == value or value != value)
        except (TypeError, ValueError, OverflowError):
            held = False
        if not held:
            raise ValueError(f"{_place(name, index, shape)} is {value!r}: it is no number, "
                             f"or {'int64' if letter == 'q' else 'float64'} cannot hold it")
