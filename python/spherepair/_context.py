# SPDX-License-Identifier: MIT
"""Opens backends, lists them, and keeps one open for each thread and name."""

from __future__ import annotations

import itertools
import operator
import os
import threading
from typing import Any, Dict, Optional, Union

from . import _handle
from ._errors import BackendError
from ._handle import Handle
from ._library import lib


class Context(Handle):
    """A backend on a device, opened. Give it to any function of the package as `backend`.

    Several threads may share a context: their calls wait for each other. A context does not survive os.fork().

    backend: "cpu", "opengl", "cuda" or "vulkan". device: the name that the driver gives.
    """

    def __init__(self, backend: str = "auto", device: Union[None, int, str] = None, threads: int = 0):
        name = None if device is None else str(device).encode()
        super().__init__("context", lib.sp_open, lib.sp_message, lib.sp_close, str(backend).encode(), name,
                         operator.index(threads))
        self.backend: str = lib.sp_backend(self._handle).decode()
        self.device: str = (lib.sp_device(self._handle) or b"").decode(errors="replace")

    def __repr__(self) -> str:
        state = "" if self._closer.alive else ", closed"
        return f"<spherepair.Context {self.backend}: {self.device}{state}>"


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


if hasattr(lib, "omp_pause_resource_all"):
    os.register_at_fork(before=_end_threads)

_kept = threading.local()


def context_of(backend: Union[str, Context]) -> Context:
    """Gives the context itself, or for a backend's name the context that this thread keeps."""
    if isinstance(backend, Context):
        return backend
    key = (backend, _handle.process)
    contexts = _kept.__dict__.setdefault("contexts", {})
    if key not in contexts:
        contexts[key] = Context(backend)
    return contexts[key]
