# SPDX-License-Identifier: MIT
"""Exact neighbour lists and sphere overlaps, in open and periodic boxes, on the CPU, OpenGL, CUDA and Vulkan.

    import spherepair
    i, j, S, d = spherepair.neighbor_list("ijSd", positions, cutoff, cell, pbc)

A pair is in a list if and only if |x_j - x_i + S H| < c in real arithmetic on the numbers as they are given. Lists
are sorted, and equal bit for bit on every backend.
"""

from ._context import Context, backends, open
from ._errors import BackendError, CapacityError
from ._library import lib as _lib
from ._lists import collisions, csr, neighbor_list, query, radius_graph
from ._plan import Pairs, Plan
from ._simulation import Simulation

__version__: str = _lib.sp_version().decode()
__all__ = ["BackendError", "CapacityError", "Context", "Pairs", "Plan", "Simulation", "backends", "collisions", "csr", "neighbor_list",
           "open", "query", "radius_graph"]
