# SPDX-License-Identifier: MIT
"""Opens backends, lists them, and keeps one open for each thread and name."""

from __future__ import annotations

import ctypes
import itertools
import operator
import os
import threading
import weakref
from typing import Any, Dict, Optional, Union

from . import _abi
from ._errors import BackendError, error
from ._library import lib


def _close(handle: ctypes.c_void_p, process: int) -> None:
    """Closes a context, but not in a child process: the driver's state stayed with the parent."""
    if os.getpid() == process:
        lib.sp_close(handle)


class Context:
    """A backend on a device, opened. Give it to any function of the package as `backend`.

    Several threads may share a context: their calls wait for each other. A context does not survive os.fork().

    backend: "cpu", "opengl", "cuda" or "vulkan". device: the name that the driver gives.
    """

    def __init__(self, backend: str = "auto", device: Union[None, int, str] = None, threads: int = 0):
        handle = ctypes.c_void_p()
        name = None if device is None else str(device).encode()
        status = lib.sp_open(str(backend).encode(), name, operator.index(threads), ctypes.byref(handle))
        if status != _abi.OK:
            raise error(status, (lib.sp_message(None) or b"").decode(errors="replace"))
        self._handle, self._lock, self._process = handle, threading.Lock(), os.getpid()
        self._closer = weakref.finalize(self, _close, handle, self._process)
        self._closer.atexit = False  # another thread may still be in a call when the interpreter ends
        self.backend: str = lib.sp_backend(handle).decode()
        self.device: str = (lib.sp_device(handle) or b"").decode(errors="replace")

    def close(self) -> None:
        """Closes the backend. Arrays that came from it stay valid. Closing twice is fine."""
        with self._lock:
            self._closer()

    def __enter__(self) -> "Context":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        state = "" if self._closer.alive else ", closed"
        return f"<spherepair.Context {self.backend}: {self.device}{state}>"

    def _call(self, function: Any, *arguments: Any, allowed: int = _abi.OK) -> int:
        """Calls `function` with the context. Raises for a status other than OK and `allowed`; returns the status."""
        if os.getpid() != self._process:
            raise BackendError("the context was opened before os.fork(): open another one in this process")
        with self._lock:
            if not self._closer.alive:
                raise BackendError("the context is closed: open another one")
            status = function(self._handle, *arguments)
            if status in (_abi.OK, allowed):
                return status
            message = (lib.sp_message(self._handle) or b"").decode(errors="replace")
        raise error(status, message)


def open(backend: str = "auto", device: Union[None, int, str] = None, threads: int = 0) -> Context:
    """Opens a backend.

    backend: "cpu", "opengl", "cuda", "vulkan", or "auto": the first of cuda, vulkan and opengl on a GPU, else cpu.
    device: number or UUID of a GPU, or None. threads: of the CPU; 0: one a core.
    Raises BackendError with the reason if the backend is missing here.
    """
    return Context(backend, device, threads)


def backends() -> Dict[str, Optional[str]]:
    """Lists every backend that the library knows: None where it opens, else the reason why it does not."""
    found: Dict[str, Optional[str]] = {}
    for index in itertools.count():
        name = lib.sp_backend_name(index)
        if not name:
            break
        try:
            Context(name.decode()).close()
            found[name.decode()] = None
        except (BackendError, MemoryError, ValueError) as failure:
            found[name.decode()] = str(failure)
    return found


def _end_threads() -> None:
    """Ends OpenMP's idle threads before a fork. A child has none of them and would wait for them forever."""
    lib.omp_pause_resource_all(1)


if hasattr(os, "register_at_fork") and hasattr(lib, "omp_pause_resource_all"):
    os.register_at_fork(before=_end_threads)

_kept = threading.local()


def context_of(backend: Union[str, Context]) -> Context:
    """Gives the context itself, or the one that this thread keeps for the backend of that name."""
    if isinstance(backend, Context):
        return backend
    key = (backend, os.getpid())
    contexts = _kept.__dict__.setdefault("contexts", {})
    if key not in contexts:
        contexts[key] = Context(backend)
    return contexts[key]
