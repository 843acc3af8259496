# SPDX-License-Identifier: MIT
"""The functions that make a list in one call."""

from __future__ import annotations

from typing import Any, Optional, Tuple, Union

from . import _inputs
from ._columns import columns, letters, to_torch
from ._context import Context
from ._on_cuda import is_on_cuda
from ._problem import Search, torch_of

Backend = Union[str, Context]


def neighbor_list(quantities: str, positions: Any, cutoff: Optional[float] = None, cell: Any = None, pbc: Any = None, *,
                  radii: Any = None, batch: Any = None, exclude: Any = None, half: bool = False, inclusive: bool = False,
                  self_pairs: bool = False, skin: float = 0, backend: Backend = "auto",
                  index_dtype: Any = "int32") -> Any:
    """The pairs (i, j, S) with |x_j - x_i + S H| < c, decided exactly on the numbers as they are given.

    All lengths have one unit, which is the caller's choice.

    quantities: letters of "ijSdD", as ASE has them, for P pairs:
        i, j: (P,) indices. S: (P, 3) images of j, in rows of the cell. d: (P,) float64 distances.
        D: (P, 3) float64 vectors x_j - x_i + S H.
    positions: (N, 3), or an ASE Atoms object, which has a cell and pbc, too. They need not lie in the cell. A tensor of
        torch or an array of cupy in CUDA's memory stays there, as the result does; the backend is then cuda.
    cutoff: c. Leave it out where there are radii.
    cell: H: (3, 3) rows, (3,) lengths, or (B, 3, 3) for B systems. None: open.
    pbc: one flag, (3,) or (B, 3). None: periodic along all rows of the cell.
    radii: (N,) or one number: c is r_i + r_j.
    batch: (N,) integers, the system of each point. No pair joins two systems. With (B, 3, 3) cells: 0 to B - 1.
    exclude: (E, 2) pairs of indices to leave out, in either order, with every S.
    half: each pair once, with i < j. inclusive: <= instead of <. self_pairs: also (i, i, 0).
    skin: is added to c.
    backend: the name of a backend, or a Context.
    index_dtype: "int32" or "int64", for i, j and S.

    Returns a tuple of arrays in the order of the letters, for one letter the array. Rows are sorted by i, j, S.
    Raises ValueError, BackendError, MemoryError.
    """
    search = Search(positions, cutoff, cell, pbc, radii=radii, batch=batch, exclude=exclude, half=half,
                    inclusive=inclusive, self_pairs=self_pairs, skin=skin)
    found = columns(search, letters(quantities), backend, index_dtype)
    listed = tuple(found[letter] for letter in quantities)
    return listed if len(listed) > 1 else listed[0]


def csr(positions: Any, cutoff: Optional[float] = None, cell: Any = None, pbc: Any = None, *, radii: Any = None,
        batch: Any = None, exclude: Any = None, half: bool = False, inclusive: bool = False, self_pairs: bool = False,
        skin: float = 0, backend: Backend = "auto", index_dtype: Any = "int32") -> Tuple[Any, Any]:
    """The list as compressed rows: the neighbours of point i are neighbours[offsets[i]:offsets[i + 1]].

    Arguments and errors are those of neighbor_list.
    Returns offsets, (N + 1,) int64, and neighbours, (P,). A neighbour with several images is in it once for each.
    """
    search = Search(positions, cutoff, cell, pbc, radii=radii, batch=batch, exclude=exclude, half=half,
                    inclusive=inclusive, self_pairs=self_pairs, skin=skin)
    found = columns(search, ("offsets", "j"), backend, index_dtype)
    return found["offsets"], found["j"]


def query(points: Any, queries: Any, cutoff: Optional[float] = None, cell: Any = None, pbc: Any = None, *,
          quantities: str = "ij", radii: Any = None, query_radii: Any = None, batch: Any = None,
          query_batch: Any = None, exclude: Any = None, inclusive: bool = False, skin: float = 0,
          backend: Backend = "auto", index_dtype: Any = "int32") -> Any:
    """The pairs of query i and point j: one set against another.

    points: (N, 3), or ASE Atoms. queries: (Q, 3). With `radii`, (N,), also `query_radii`, (Q,): c is their sum.
    With `batch`, (N,), also `query_batch`, (Q,). exclude: (E, 2), a query and a point each.
    The other arguments, the result and the errors are those of neighbor_list.
    """
    search = Search(points, cutoff, cell, pbc, radii=radii, batch=batch, exclude=exclude, inclusive=inclusive, skin=skin,
                    queries=queries, query_radii=query_radii, query_batch=query_batch)
    found = columns(search, letters(quantities), backend, index_dtype)
    listed = tuple(found[letter] for letter in quantities)
    return listed if len(listed) > 1 else listed[0]


def collisions(centers: Any, radii: Any, cell: Any = None, pbc: Any = None, *, batch: Any = None,
               backend: Backend = "auto", index_dtype: Any = "int32") -> Any:
    """The spheres that overlap: |x_j - x_i + S H| < r_i + r_j. Spheres that touch in one point do not.

    centers: (N, 3). radii: (N,) or one number. The other arguments and the errors are those of neighbor_list.
    Returns (P, 2), each pair once with i < j, sorted. In a periodic cell a pair is in it once for each image that
    overlaps; a sphere that overlaps its own image is the pair (i, i).
    """
    search = Search(centers, None, cell, pbc, radii=radii, batch=batch, half=True)
    return _stacked(search, "ij", 1, backend, index_dtype)


def radius_graph(x: Any, r: float, batch: Any = None, loop: bool = False, flow: str = "source_to_target",
                 cell: Any = None, pbc: Any = None, *, backend: Backend = "auto") -> Any:
    """The edges between points at a distance below r, as torch_cluster orders them, without a limit to their number.

    x: (N, 3), (N, 2), (N, 1) or (N,). r: in the unit of x. batch: (N,) integers, sorted or not. loop: also (i, i).
    flow: "source_to_target": row 0 is the neighbour j, row 1 the centre i; "target_to_source": the reverse.
    cell, pbc and the errors are those of neighbor_list; an edge is in it once for each periodic image.
    Returns (2, E) int64, sorted by centre, then neighbour.
    """
    if flow not in ("source_to_target", "target_to_source"):
        raise ValueError(f"flow is {flow!r}: source_to_target or target_to_source")
    given = hasattr(x, "get_positions") or is_on_cuda(x)
    positions = x if given else _inputs.padded_points(x, "x")
    search = Search(positions, r, cell, pbc, batch=batch, self_pairs=loop)
    search.torch = torch_of(x)
    return _stacked(search, "ji" if flow == "source_to_target" else "ij", 0, backend, "int64")


def _stacked(search: Search, order: str, axis: int, backend: Backend, index_dtype: Any) -> Any:
    """Two columns as one array: (2, P) along axis 0, (P, 2) along axis 1."""
    torch, search.torch = search.torch, None
    found = columns(search, "ij", backend, index_dtype)
    if search.cuda is not None:
        return search.cuda.stacked(found[order[0]], found[order[1]], axis)
    stacked = _inputs.arrays.stacked(found[order[0]], found[order[1]], axis)
    return stacked if torch is None else to_torch(torch, stacked)
