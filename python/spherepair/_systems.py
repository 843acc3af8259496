# SPDX-License-Identifier: MIT
"""Several systems in one call: sorts points by system, and maps lists back to the caller's numbers."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence

from ._inputs import arrays, integers
from ._views import View


class Sorted(NamedTuple):
    """The systems of a set of points. offsets: B + 1. order: point order[k] is in row k; None: as given."""

    offsets: Optional[View] = None
    order: Any = None


def _numbers(batch: Any, name: str, rows: int, boxes: int) -> Any:
    given = integers(batch, name)
    if given.shape != (rows,):
        raise ValueError(f"{name} has shape {given.shape}: the number of a system for each of {rows} points is needed")
    systems = arrays.values(given)
    wrong = arrays.first_outside(systems, boxes if boxes > 1 else 2**62)
    if wrong is not None:
        limit = f"systems are 0 to {boxes - 1}, one for each cell" if boxes > 1 else "systems start at 0"
        raise ValueError(f"{name}[{wrong}] is {systems[wrong]}: {limit}")
    return systems


def sort(batches: Sequence[Any], names: Sequence[str], rows: Sequence[int], boxes: int) -> Sequence[Sorted]:
    """Sorts each set of points by system. All sets get the same systems: one for each box, or the numbers that occur."""
    if all(batch is None for batch in batches):
        return [Sorted()] * len(batches)
    for batch, name in zip(batches, names):
        if batch is None:
            raise ValueError(f"{name} is missing: points and queries both need the numbers of their systems")
    numbers = [_numbers(*given, boxes) for given in zip(batches, names, rows)]
    orders = [arrays.stable_order(systems) for systems in numbers]
    ordered = [systems if order is None else arrays.gather(systems, order) for systems, order in zip(numbers, orders)]
    systems = range(boxes) if boxes > 1 else arrays.distinct(*ordered)
    if len(systems) == 0:
        systems = [0]
    return [Sorted(arrays.starts(kept, systems), order) for kept, order in zip(ordered, orders)]
