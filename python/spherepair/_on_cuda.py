# SPDX-License-Identifier: MIT
"""Uses arrays in CUDA's memory in place: torch tensors, cupy arrays, and others with `__cuda_array_interface__`."""

from __future__ import annotations

import sys
from typing import Any, Optional

from ._views import View, contiguous

CUDA = (2, 13)  # DLPack's numbers of CUDA's memory and its managed memory


def is_on_cuda(obj: Any) -> bool:
    """Says whether an array lies in CUDA's memory."""
    device = getattr(obj, "__dlpack_device__", None)
    if callable(device):
        return device()[0] in CUDA
    return hasattr(obj, "__cuda_array_interface__")


def view(obj: Any, name: str) -> View:
    """Gives a view of an array in CUDA's memory."""
    if getattr(obj, "requires_grad", False):
        obj = obj.detach()
    interface = getattr(obj, "__cuda_array_interface__", None)
    if interface is None:
        raise ValueError(f"{name} is in CUDA's memory without a __cuda_array_interface__: give a tensor of torch, or an "
                         "array of cupy")
    code, shape = interface["typestr"][1:], tuple(interface["shape"])
    if code not in ("f4", "f8") or interface["typestr"][0] not in "<|":
        raise ValueError(f"{name} has elements of type {getattr(obj, 'dtype', code)}: give float64 or float32")
    strides = interface.get("strides") or contiguous(shape, int(code[1:]))
    number = obj.__dlpack_device__()[1] if hasattr(obj, "__dlpack_device__") else 0
    return View(interface["data"][0], shape, tuple(strides), code, True, obj, number)


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
        self._interface = positions.__cuda_array_interface__ if not self.torch else {}

    def stream(self) -> int:
        """The stream in which the caller uses the arrays."""
        if self.torch:
            return self.torch.cuda.current_stream(self.number).cuda_stream
        if self.cupy:
            return self.cupy.cuda.get_current_stream().ptr
        return self._interface.get("stream") or 0

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
