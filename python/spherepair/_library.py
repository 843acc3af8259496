# SPDX-License-Identifier: MIT
"""Finds and loads the shared library once, as `lib`."""

from __future__ import annotations

import ctypes
import os
import pathlib

from . import _abi

SONAME = "libspherepair.so.0"


def _candidates() -> list[str]:
    """Where the library may be. A path in SPHEREPAIR_LIBRARY is the only one."""
    named = os.environ.get("SPHEREPAIR_LIBRARY")
    if named:
        return [named]
    beside = pathlib.Path(__file__).parent / "libspherepair.so"
    return ([str(beside)] if beside.exists() else []) + [SONAME]


def load(path: str) -> ctypes.CDLL:
    """Loads the library at `path` and declares its functions. Raises ImportError if the ABI is another one."""
    library = ctypes.CDLL(path)
    if not hasattr(library, "sp_abi_version"):
        raise ImportError(f"{path} is not spherepair's library: it has no sp_abi_version")
    found = library.sp_abi_version()
    if found != _abi.ABI_VERSION:
        raise ImportError(f"{path} has version {found} of the ABI, this package needs {_abi.ABI_VERSION}: "
                          "install a library and a package of the same release")
    for name, (result, arguments) in _abi.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def find() -> ctypes.CDLL:
    """Loads the first library that the loader can open. Raises ImportError if there is none."""
    reasons = []
    for path in _candidates():
        try:
            return load(path)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(f"spherepair's library cannot be loaded: {'; '.join(reasons)}. "
                      "Install it, or set SPHEREPAIR_LIBRARY to the path of libspherepair.so")


lib = find()
