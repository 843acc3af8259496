# SPDX-License-Identifier: MIT
"""Compile times of the GL driver."""


def driver_milliseconds(machine):
    """Kernel -> compile time by the GL driver, from `spherepair devices --compile`; empty without a record."""
    return next((backend["compile_ms"] for root in machine.sources.values() for backend in root.get("backends", [])
                 if isinstance(backend, dict) and backend.get("compile_ms")), {})
