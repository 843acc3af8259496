# SPDX-License-Identifier: MIT
"""What Simulation.draw hands to the library: the camera and the colours, and the pixels to write."""

from __future__ import annotations

import ctypes
import operator
from typing import Any, Optional, Tuple

from . import _abi, _inputs
from ._inputs import arrays
from ._views import View, numpy, refuse_device_memory, view

WIDEST = 16384  # pixels along either axis


def _numbers(values: Any, count: int, name: str) -> Any:
    """Copies so many numbers for the library; None if they are not given."""
    if values is None:
        return None
    if isinstance(values, (str, bytes)) or not hasattr(values, "__len__") or len(values) != count:
        raise ValueError(f"{name} is {values!r}: {count} numbers are needed")
    return (ctypes.c_double * count)(*(_inputs.number(value, f"{name}[{k}]") for k, value in enumerate(values)))


def struct(eye: Any, target: Any, up: Any, azimuth: Optional[float], elevation: Optional[float], field: float, nearest: float,
           color: str, color_range: Any, samples: int, light: bool, ground: bool) -> Tuple[_abi.Drawing, Any]:
    """Makes the C struct, and the objects that it points to. They must live as long."""
    places = {"eye": _numbers(eye, 3, "eye"), "target": _numbers(target, 3, "target"), "up": _numbers(up, 3, "up"),
              "color_range": _numbers(color_range, 2, "color_range")}
    drawing = _abi.Drawing(size=ctypes.sizeof(_abi.Drawing), color=str(color).encode(), samples=operator.index(samples),
                           plain=not light, no_ground=not ground)
    if not 1 <= drawing.samples == samples:
        raise ValueError(f"samples is {samples}: it must be 1 to 1024")
    for name, place in places.items():
        if place is not None:
            setattr(drawing, name, ctypes.cast(place, ctypes.POINTER(ctypes.c_double)))
    angles = {"azimuth": (azimuth, 30.0), "elevation": (elevation, 15.0)}
    for name, (angle, usual) in angles.items():
        setattr(drawing, name, _inputs.number(angle, name) if angle is not None else 0.0 if eye is not None else usual)
    drawing.field, drawing.nearest = _inputs.number(field, "field"), _inputs.number(nearest, "nearest")
    if drawing.field == 0:
        raise ValueError("field is 0: it must be above 0 and below 180 degrees")
    return drawing, places


def pixels(width: Optional[int], height: Optional[int], out: Any) -> Any:
    """Gives the caller's array, or a new one of height x width x 4 bytes."""
    shape = getattr(out, "shape", ())[:2] if out is not None else (720, 1280)
    wanted = tuple(usual if given is None else operator.index(given) for given, usual in zip((height, width), shape))
    if out is None:
        if not all(1 <= length <= WIDEST for length in wanted):
            raise ValueError(f"an image of {wanted[1]} x {wanted[0]} pixels: each must be 1 to {WIDEST}")
        return arrays.new((*wanted, 4), "u1")
    if wanted != tuple(shape):
        raise ValueError(f"out has shape {tuple(out.shape)}, but height and width are {wanted[0]} and {wanted[1]}")
    return out


def array_of(out: Any) -> _abi.Array:
    """Gives H x W x 4 writable bytes as the library has them: H rows of 4 W bytes."""
    refuse_device_memory(out, "out")
    try:
        buffer = memoryview(out)
    except TypeError:
        raise ValueError(f"out is of type {type(out).__name__}: give an array of uint8, such as numpy's") from None
    if buffer.ndim != 3 or buffer.shape[2] != 4 or buffer.format != "B":
        raise ValueError(f"out has shape {buffer.shape} and elements {buffer.format!r}: height x width x 4 uint8 are needed")
    if buffer.readonly:
        raise ValueError("out is read-only: give an array that can be written")
    if buffer.strides[1:] != (4, 1) or (numpy is None and not buffer.c_contiguous):
        raise ValueError(f"out has strides {buffer.strides}: the bytes of a row must follow each other")
    rows, columns = buffer.shape[:2]
    given = view(buffer, "out")
    return View(given.address, (rows, 4 * columns), (buffer.strides[0], 1), "u1", True, given.keep).struct()
