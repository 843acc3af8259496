# SPDX-License-Identifier: MIT
"""Simulation: moves spheres that fall, bounce, and push each other or pass through each other."""

from __future__ import annotations

import ctypes
import operator
import os
from typing import Any, Optional, Union

from . import _abi, _drawing, _inputs
from ._columns import List
from ._handle import Handle
from ._inputs import arrays
from ._library import lib
from ._views import view


def _path(file: Any) -> bytes:
    """Gives the path as the system has it."""
    path = os.fsencode(file)
    if b"\0" in path:
        raise ValueError(f"{file!r} is no path: it has a null character")
    return path


class Simulation(Handle):
    """Moves spheres on a backend of its own. Lengths in metres, times in seconds, y points up.

    positions: (N, 3), rounded to float32. radii: (N,) or one number. velocities: (N, 3), m/s; None: at rest.
    contact: "none": spheres pass through each other and bounce off the plane; "spring", "hertz" or "quartic": they push
        each other, the plane and the walls.
    gravity: m/s^2, downwards. plane: its height. restitution: speed after a bounce over the speed before, 0 to 1.
    dt: seconds of a step; None: 1/64, with contacts a fraction of the shortest contact.
    stiffness: N/m (spring), N/m^1.5 (hertz), N/m^3 (quartic); None: the fastest sphere enters by 1 % of a radius.
    density: kg/m^3; None: 1000. drag: 1/s: speeds alone fall to 1/e in 1/drag seconds.
    walls: ((x, y, z), (x, y, z)): the lowest and the highest corner of a closed box, whose floor is the plane.
    pbc: one flag or three: along these axes the box of `walls` repeats and has no walls. With y give gravity=0.
    backend, device, threads: as for open().

    Steps have the same bits on every backend. Raises ValueError, BackendError, MemoryError. After a step that fails every
    call raises ValueError.
    """

    def __init__(self, positions: Any, radii: Any, velocities: Any = None, *, contact: str = "none",
                 gravity: float = 9.81, plane: float = 0.0, restitution: float = 1.0, dt: Optional[float] = None,
                 stiffness: Optional[float] = None, density: Optional[float] = None, drag: float = 0.0,
                 walls: Any = None, pbc: Any = False, backend: str = "auto", device: Union[None, int, str] = None, threads: int = 0):
        points = _inputs.points(positions, "positions")
        keep = {"positions": points, "radii": _inputs.radii_of(radii, "radii", points.shape[0])}
        if velocities is not None:
            keep["velocities"] = _inputs.points(velocities, "velocities")
        if walls is not None:
            keep["walls"] = _inputs.points(walls, "walls")
        scene = _abi.Scene(size=ctypes.sizeof(_abi.Scene), contact=str(contact).encode())
        scene.periodic[:] = _inputs.flags(pbc)
        for name, given in keep.items():
            setattr(scene, name, given.struct())
        numbers = {"gravity": gravity, "plane": plane, "restitution": restitution, "dt": dt, "stiffness": stiffness,
                   "density": density, "drag": drag}
        for name, value in numbers.items():
            setattr(scene, name, 0.0 if value is None else _inputs.number(value, name))
        self._open(lib.sp_simulation_open, backend, device, threads, ctypes.byref(scene))

    def _open(self, function: Any, backend: str, device: Union[None, int, str], threads: int, *start: Any) -> None:
        name = None if device is None else str(device).encode()
        super().__init__("simulation", function, lib.sp_simulation_message, lib.sp_simulation_close, str(backend).encode(), name,
                         operator.index(threads), *start)
        self._spheres = self._call(lib.sp_simulation_spheres)

    @classmethod
    def resume(cls, checkpoint: Any, *, backend: str = "auto", device: Union[None, int, str] = None,
               threads: int = 0) -> Simulation:
        """Continues from a checkpoint: a path (str or os.PathLike), or bytes that checkpoint() returned.

        Any backend makes the same bits as a run without interruption. `spherepair run --save` makes such files, too.
        Raises ValueError for a file that cannot be read, is no checkpoint, or is cut off or damaged.
        """
        simulation = cls.__new__(cls)
        if isinstance(checkpoint, (str, os.PathLike)):
            simulation._open(lib.sp_simulation_resume, backend, device, threads, _path(checkpoint))
            return simulation
        try:
            given = bytes(memoryview(checkpoint))
        except TypeError:
            raise ValueError(f"checkpoint is of type {type(checkpoint).__name__}: give a path or bytes") from None
        simulation._open(lib.sp_simulation_resume_bytes, backend, device, threads, given, len(given))
        return simulation

    def save(self, file: Union[str, os.PathLike]) -> None:
        """Writes a checkpoint, which resume() and `spherepair run --resume` read.

        A file of that name is replaced once the new one is whole. Raises ValueError if it cannot be written.
        """
        self._call(lib.sp_simulation_save, _path(file))

    def checkpoint(self) -> bytes:
        """Gives the bytes that save() writes."""
        size = ctypes.c_size_t()
        self._call(lib.sp_simulation_save_bytes, None, 0, ctypes.byref(size), allowed=_abi.CAPACITY)
        made = ctypes.create_string_buffer(size.value)
        self._call(lib.sp_simulation_save_bytes, made, size, ctypes.byref(size))
        return made.raw

    def move(self, steps: int = 1) -> None:
        """Makes `steps` steps."""
        if operator.index(steps) < 0:
            raise ValueError(f"steps is {steps}: it must not be negative")
        self._call(lib.sp_simulation_move, steps)

    @property
    def dt(self) -> float:
        """Seconds of a step."""
        return self._call(lib.sp_simulation_dt)

    @property
    def steps(self) -> int:
        """Steps made so far."""
        return self._call(lib.sp_simulation_steps)

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return self.steps * self.dt

    def _vectors(self, of_velocities: bool) -> Any:
        vectors = arrays.new((self._spheres, 3), "f4")
        struct = view(vectors, "vectors").struct()
        wanted = (None, ctypes.byref(struct)) if of_velocities else (ctypes.byref(struct), None)
        self._call(lib.sp_simulation_state, *wanted)
        return vectors

    @property
    def positions(self) -> Any:
        """The centres now: (N, 3) float32, a new array each time."""
        return self._vectors(False)

    @property
    def velocities(self) -> Any:
        """The velocities now: (N, 3) float32, m/s, a new array each time."""
        return self._vectors(True)

    def pairs(self) -> Any:
        """Lists the spheres that overlap now: (P, 2) int32, each pair once with i < j, sorted."""
        pointer = ctypes.POINTER(_abi.Pairs)()
        self._call(lib.sp_simulation_pairs, ctypes.byref(pointer))
        made = List(pointer)
        return arrays.stacked(arrays.output(made.column("i")), arrays.output(made.column("j")), 1)

    def draw(self, width: Optional[int] = None, height: Optional[int] = None, *, eye: Any = None, target: Any = None,
             up: Any = None, azimuth: Optional[float] = None, elevation: Optional[float] = None, field: float = 30.0,
             nearest: float = 0.0, color: str = "contacts", color_range: Any = None, samples: int = 16, light: bool = True,
             ground: bool = True, out: Any = None) -> Any:
        """Draws the spheres at their current positions: (height, width, 4) uint8, RGBA, the upper row first.

        width, height: pixels, 1 to 16384; None: 1280 and 720, or those of `out`.
        eye, target, up: the camera's place, the point that it looks at, and the direction upwards. Without eye all
            spheres are in view, from `azimuth` around up (30) and `elevation` above the horizon (15), in degrees.
        field: of view, from the lower to the upper edge, degrees. nearest: least depth, m; 0: chosen.
        color: "contacts", "radius" or "speed". color_range: radii or speeds with the first and the last colour; None: those
            of the spheres now.
        samples: of each pixel, 1 to 1024. light: ambient occlusion and shadows. ground: at the plane; only with light.
        out: the array to write to, in the host's memory; with numpy its rows may be apart. It is returned.

        The pixels are those of `spherepair render --no-box --no-legend`, the same on every backend.
        """
        drawing, keep = _drawing.struct(eye, target, up, azimuth, elevation, field, nearest, color, color_range, samples, light,
                                        ground)
        pixels = _drawing.pixels(width, height, out)
        self._call(lib.sp_simulation_draw, ctypes.byref(drawing), ctypes.byref(_drawing.array_of(pixels)))
        del keep  # the struct points into it
        return pixels
