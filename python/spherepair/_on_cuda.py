# SPDX-License-Identifier: MIT
"""Uses arrays in CUDA's memory in place: torch tensors, cupy arrays, and others with `__cuda_array_interface__` or DLPack."""

from __future__ import annotations

import sys
from typing import Any, Optional, Tuple

from . import _dlpack
from ._views import View, contiguous

CUDA = (2, 13)  # DLPack's numbers of CUDA's memory and its managed memory
DEFAULT_STREAM = 1  # DLPack's number of CUDA's default stream
TYPES = {"f4": "float32", "f8": "float64", "i4": "int32", "i8": "int64"}


def is_on_cuda(obj: Any) -> bool:
    """Says whether an array lies in CUDA's memory."""
    device = getattr(obj, "__dlpack_device__", None)
    if callable(device):
        return device()[0] in CUDA
    return hasattr(obj, "__cuda_array_interface__")


def view(obj: Any, name: str, codes: Tuple[str, ...] = ("f8", "f4")) -> View:
    """Gives a view of an array in CUDA's memory, whose elements are of one of these types."""
    if not is_on_cuda(obj):
        raise ValueError(f"{name} is in the host's memory, but other arrays are in CUDA's: all must be in one")
    if getattr(obj, "requires_grad", False):
        obj = obj.detach()
    interface = getattr(obj, "__cuda_array_interface__", None)
    number = obj.__dlpack_device__()[1] if hasattr(obj, "__dlpack_device__") else 0
    if interface is None:
        given = View(*_dlpack.read(obj, name, stream=DEFAULT_STREAM), number)
    else:
        code, shape = interface["typestr"][1:], tuple(interface["shape"])
        strides = interface.get("strides") or contiguous(shape, int(code[1:]))
        given = View(interface["data"][0], shape, tuple(strides), code, interface["typestr"][0] in "<|", obj, number)
    if given.code not in codes or not given.native:
        raise ValueError(f"{name} has elements of type {getattr(obj, 'dtype', given.code)}: "
                         f"give {' or '.join(map(TYPES.get, codes))}")
    return given


def on_host(obj: Any, name: str) -> Any:
    """Copies a small array that the library needs on the host; gives other objects as they are."""
    if obj is None or not is_on_cuda(obj):
        return obj
    for method in ("cpu", "get"):  # torch's and cupy's copies to the host
        if hasattr(obj, method):
            return getattr(obj, method)()
    raise ValueError(f"{name} is in CUDA's memory: copy it to the host's first")


class Column:
    """A column of a list, in CUDA's memory. It keeps the list."""

    def __init__(self, source: View):
        self._keep = source.keep
        self.shape = source.shape
        self.__cuda_array_interface__ = {"version": 3, "shape": source.shape, "typestr": "<" + source.code,
                                         "strides": None, "data": (source.address, False)}


class Library:
    """The package of a call's arrays. Makes arrays of the same kind that use the list's memory."""

    def __init__(self, positions: Any, number: int):
        torch, cupy = sys.modules.get("torch"), sys.modules.get("cupy")
        self.torch = torch if torch is not None and isinstance(positions, torch.Tensor) else None
        self.cupy = cupy if cupy is not None and isinstance(positions, cupy.ndarray) else None
        self.number = number

    def stream(self, positions: Any) -> int:
        """The stream in which the caller uses the arrays: torch's or cupy's current one, else that of the positions."""
        if self.torch:
            return self.torch.cuda.current_stream(self.number).cuda_stream
        if self.cupy:
            return self.cupy.cuda.get_current_stream().ptr
        return getattr(positions, "__cuda_array_interface__", {}).get("stream") or 0

    def new(self, shape: Tuple[int, ...], code: str) -> Any:
        """Allocates an array of zeros."""
        if self.torch:
            return self.torch.zeros(shape, dtype=getattr(self.torch, TYPES[code]), device=f"cuda:{self.number}")
        if self.cupy:
            with self.cupy.cuda.Device(self.number):
                return self.cupy.zeros(shape, code)
        raise ValueError("only torch and cupy allocate arrays in CUDA's memory here: give your own to plan.into(i=..., ...)")

    def radii(self, radii: Any, name: str, rows: int) -> View:
        """Gives radii in CUDA's memory; torch and cupy copy them there from the host."""
        if not is_on_cuda(radii):
            if not self.torch and not self.cupy:
                raise ValueError(f"{name} are in the host's memory, the positions in CUDA's: both must be in one")
            radii = (self.torch.as_tensor(radii, dtype=self.torch.float64, device=f"cuda:{self.number}")
                     if self.torch else self.cupy.asarray(radii, dtype="f8"))
        given = view(radii, name)
        if given.shape == ():
            return View(given.address, (rows,), (0,), *given[3:])
        if given.shape != (rows,):
            raise ValueError(f"{name} has shape {given.shape}: one radius for each of {rows} points is needed")
        return given

    def array(self, source: View, code: Optional[str] = None) -> Any:
        """Gives an array that uses the source's memory, or a copy as integers of another size."""
        column = Column(source)
        if self.torch:
            tensor = self.torch.as_tensor(column, device=f"cuda:{self.number}")
            return tensor if code is None else tensor.to({"i4": self.torch.int32, "i8": self.torch.int64}[code])
        if self.cupy:
            array = self.cupy.asarray(column)
            return array if code is None else array.astype(code, copy=False)
        if code not in (None, source.code):
            raise ValueError("index_dtype must be int32 for positions that are neither torch's nor cupy's")
        return column

    def stacked(self, first: Any, second: Any, axis: int) -> Any:
        package = self.torch or self.cupy
        if not package:
            raise ValueError("positions in CUDA's memory must be a tensor of torch or an array of cupy here")
        return package.stack((first, second), axis)
