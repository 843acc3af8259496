# SPDX-License-Identifier: MIT
"""Reads the memory behind `__dlpack__`."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_int32, c_int64, c_uint8, c_uint16, c_uint64, c_void_p
from typing import Any, Tuple

HOST_DEVICES = (1, 3, 11)  # the host's memory: pageable, pinned by CUDA, pinned by ROCm
_KINDS = {0: "i", 1: "u", 2: "f", 6: "b"}


class _Tensor(ctypes.Structure):
    """DLTensor, the first member of DLManagedTensor. Strides are in elements."""

    _fields_ = [("data", c_void_p), ("device_type", c_int32), ("device_id", c_int32), ("dimensions", c_int32),
                ("code", c_uint8), ("bits", c_uint8), ("lanes", c_uint16), ("shape", POINTER(c_int64)),
                ("strides", POINTER(c_int64)), ("byte_offset", c_uint64)]


_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_pointer.restype, _pointer.argtypes = c_void_p, [ctypes.py_object, c_char_p]


def read(obj: Any, name: str, **stream: int) -> Tuple[int, Tuple[int, ...], Tuple[int, ...], str, bool, Any]:
    """Gives the fields of a View, which keeps the capsule. The capsule frees the memory when it is collected.

    stream: for a device's memory, where the numbers are used.
    """
    capsule = obj.__dlpack__(**stream)
    tensor = _Tensor.from_address(_pointer(capsule, b"dltensor"))
    if tensor.code not in _KINDS or tensor.bits not in (8, 16, 32, 64) or tensor.lanes != 1:
        raise ValueError(f"{name} has elements of type {getattr(obj, 'dtype', 'unknown')}: give float64 or float32")
    size, shape = tensor.bits // 8, tuple(tensor.shape[:tensor.dimensions])
    strides = []
    step = size
    for k in reversed(range(len(shape))):
        strides.insert(0, tensor.strides[k] * size if tensor.strides else step)
        step *= shape[k]
    address = (tensor.data or 0) + tensor.byte_offset
    return address, shape, tuple(strides), f"{_KINDS[tensor.code]}{size}", True, capsule
