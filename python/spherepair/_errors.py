# SPDX-License-Identifier: MIT
"""The exceptions, and the status numbers that raise them."""

from __future__ import annotations

from . import _abi


class CapacityError(RuntimeError):
    """The arrays of a plan are too short for the list.

    needed: pairs in the list. given: rows in the arrays.
    """

    def __init__(self, needed: int, given: int):
        super().__init__(f"the list has {needed} pairs, the arrays have {given} rows: allocate {needed}")
        self.needed, self.given = needed, given

    def __reduce__(self):
        return CapacityError, (self.needed, self.given)


class BackendError(RuntimeError):
    """A backend cannot be opened here, or its driver failed. reason: the text."""

    def __init__(self, reason: str):
        super().__init__(reason)
        self.reason = reason


def error(status: int, message: str) -> Exception:
    """Makes the exception for a status other than OK, with the library's message."""
    if status == _abi.MEMORY:
        return MemoryError(message)
    return BackendError(message) if status == _abi.BACKEND else ValueError(message)
