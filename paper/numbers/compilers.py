# SPDX-License-Identifier: MIT
"""Compile times of the GL driver."""


def driver_record(machine):
    """(id, kernel -> compile time by the GL driver) of `spherepair devices --compile`; empty without a record."""
    return next(((root["id"], backend["compile_ms"]) for root in machine.sources.values() for backend in root.get("backends", [])
                 if isinstance(backend, dict) and backend.get("compile_ms")), ("", {}))


def driver_milliseconds(machine):
    return driver_record(machine)[1]
