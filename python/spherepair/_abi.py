# SPDX-License-Identifier: MIT
"""The structs and functions of spherepair.h, for ctypes."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint8, c_uint32, c_uint64, c_void_p

ABI_VERSION = 2

OK, ARGUMENT, NONFINITE, RANGE, CAPACITY, MEMORY, BACKEND = range(7)  # sp_status
SHIFTS, VECTORS, DISTANCES, OFFSETS = 1, 2, 4, 8  # columns that sp_list makes besides i and j

TYPES = {"f4": 0, "f8": 1, "i4": 2, "i8": 3, "u1": 4}  # sp_type of a kind and a size in bytes
CODES = {number: code for code, number in TYPES.items()}
HOST, CUDA = 1, 2  # DLPack's numbers of the host's memory and of CUDA's


class Array(ctypes.Structure):
    """sp_array: strides are in elements."""

    _fields_ = [("data", c_void_p), ("rows", c_int64), ("columns", c_int64), ("row_stride", c_int64),
                ("column_stride", c_int64), ("type", c_int32), ("device_type", c_int32), ("device_id", c_int32)]


class Problem(ctypes.Structure):
    """sp_problem: the points and options of a search."""

    _fields_ = [("size", c_size_t), ("positions", Array), ("radii", Array), ("cutoff", c_double), ("skin", c_double),
                ("boxes", Array), ("periodic", Array), ("offsets", Array), ("queries", Array),
                ("query_radii", Array), ("query_offsets", Array), ("exclusions", Array), ("half", c_int32),
                ("inclusive", c_int32), ("self_pairs", c_int32), ("stream", c_void_p)]


class Pairs(ctypes.Structure):
    """sp_pairs: the columns of a list."""

    _fields_ = [("size", c_size_t), ("count", c_int64), ("first", Array), ("second", Array), ("shifts", Array),
                ("vectors", Array), ("distances", Array), ("offsets", Array), ("found", Array)]


class Scene(ctypes.Structure):
    """sp_scene: where spheres start."""

    _fields_ = [("size", c_size_t), ("positions", Array), ("velocities", Array), ("radii", Array), ("plane", c_double),
                ("gravity", c_double), ("restitution", c_double), ("dt", c_double), ("contact", c_char_p),
                ("stiffness", c_double), ("density", c_double), ("drag", c_double), ("walls", Array),
                ("periodic", c_uint8 * 3)]


class Drawing(ctypes.Structure):
    """sp_drawing: what an image shows."""

    _fields_ = [("size", c_size_t), ("eye", POINTER(c_double)), ("target", POINTER(c_double)), ("up", POINTER(c_double)),
                ("azimuth", c_double), ("elevation", c_double), ("field", c_double), ("nearest", c_double),
                ("color", c_char_p), ("color_range", POINTER(c_double)), ("samples", c_int32), ("plain", c_int32),
                ("no_ground", c_int32)]


# name: (type of the result, types of the arguments)
FUNCTIONS = {
    "sp_abi_version": (c_uint32, []),
    "sp_version": (c_char_p, []),
    "sp_backend_name": (c_char_p, [c_int32]),
    "sp_open": (c_int32, [c_char_p, c_char_p, c_int32, POINTER(c_void_p)]),
    "sp_close": (None, [c_void_p]),
    "sp_backend": (c_char_p, [c_void_p]),
    "sp_device": (c_char_p, [c_void_p]),
    "sp_message": (c_char_p, [c_void_p]),
    "sp_count": (c_int32, [c_void_p, POINTER(Problem), POINTER(c_int64)]),
    "sp_list": (c_int32, [c_void_p, POINTER(Problem), c_uint32, POINTER(POINTER(Pairs))]),
    "sp_free": (None, [POINTER(Pairs)]),
    "sp_fill": (c_int32, [c_void_p, POINTER(Problem), POINTER(Pairs)]),
    "sp_simulation_open": (c_int32, [c_char_p, c_char_p, c_int32, POINTER(Scene), POINTER(c_void_p)]),
    "sp_simulation_close": (None, [c_void_p]),
    "sp_simulation_move": (c_int32, [c_void_p, c_uint64]),
    "sp_simulation_state": (c_int32, [c_void_p, POINTER(Array), POINTER(Array)]),
    "sp_simulation_pairs": (c_int32, [c_void_p, POINTER(POINTER(Pairs))]),
    "sp_simulation_save": (c_int32, [c_void_p, c_char_p]),
    "sp_simulation_save_bytes": (c_int32, [c_void_p, c_void_p, c_size_t, POINTER(c_size_t)]),
    "sp_simulation_resume": (c_int32, [c_char_p, c_char_p, c_int32, c_char_p, POINTER(c_void_p)]),
    "sp_simulation_resume_bytes": (c_int32, [c_char_p, c_char_p, c_int32, c_void_p, c_size_t, POINTER(c_void_p)]),
    "sp_simulation_draw": (c_int32, [c_void_p, POINTER(Drawing), POINTER(Array)]),
    "sp_simulation_spheres": (c_uint64, [c_void_p]),
    "sp_simulation_dt": (c_double, [c_void_p]),
    "sp_simulation_steps": (c_uint64, [c_void_p]),
    "sp_simulation_message": (c_char_p, [c_void_p]),
}
