# SPDX-License-Identifier: MIT
"""Handle: an object that the library opened, used by one thread at a time until it is closed."""

from __future__ import annotations

import ctypes
import os
import threading
import weakref
from typing import Any

from . import _abi
from ._errors import BackendError, error


process = object()  # another one in each child process: compared sooner than os.getpid() asks the system


def _forked() -> None:
    global process
    process = object()


os.register_at_fork(after_in_child=_forked)


def _close(function: Any, handle: ctypes.c_void_p, opened_in: object) -> None:
    """Closes a handle, but not in a child process: the driver's state stayed with the parent."""
    if opened_in is process:
        function(handle)


class Handle:
    """Owns a pointer of the library's. Calls of several threads wait for each other. It does not survive os.fork()."""

    def __init__(self, name: str, open_it: Any, message: Any, close_it: Any, *arguments: Any):
        """Calls open_it(*arguments, &pointer). Raises the exception of its status. name: the object's, in messages."""
        self._name, self._message, self._handle = name, message, ctypes.c_void_p()
        status = open_it(*arguments, ctypes.byref(self._handle))
        if status != _abi.OK:
            raise error(status, (message(None) or b"").decode(errors="replace"))
        self._lock, self._process = threading.Lock(), process
        self._closer = weakref.finalize(self, _close, close_it, self._handle, self._process)
        self._closer.atexit = False  # another thread may still be in a call when the interpreter ends

    def close(self) -> None:
        """Closes the object. Arrays that came from it stay valid. Closing twice is fine."""
        with self._lock:
            self._closer()

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _call(self, function: Any, *arguments: Any, allowed: int = _abi.OK) -> Any:
        """Calls `function` with the pointer and returns its result. Raises for a status other than OK and `allowed`."""
        if self._process is not process:
            raise BackendError(f"the {self._name} was opened before os.fork(): open another one in this process")
        with self._lock:
            if not self._closer.alive:
                raise BackendError(f"the {self._name} is closed: open another one")
            result = function(self._handle, *arguments)
            if function.restype is not ctypes.c_int32 or result in (_abi.OK, allowed):
                return result
            message = (self._message(self._handle) or b"").decode(errors="replace")
        raise error(result, message)
