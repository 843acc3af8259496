# SPDX-License-Identifier: MIT
"""The recorded machine, read once, and copies of it with the times of some records changed."""
import copy
import pathlib
import sys
from dataclasses import replace
from functools import lru_cache

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper.records import APIS, DATA, MAIN, Machine  # noqa: E402  (the path must be set first)

read = lru_cache(Machine)


def recorded(name=MAIN):
    """A copy, whose records and sources may be replaced or added to."""
    machine = copy.copy(read(DATA / name, whole=name != APIS))
    machine.records, machine.sources = list(machine.records), dict(machine.sources)
    machine.used, machine.notes, machine.runs = {}, {}, {}
    return machine


def three_apis():
    """The machine on which OpenGL, Vulkan and CUDA were timed in turns."""
    return recorded(APIS)


def changed(wanted, factor, name=MAIN):
    """A recorded machine with the times of some records made longer or shorter by a factor; none is of a busy machine."""
    machine = recorded(name)

    def scaled(record):
        times = factor(record) if wanted(record) else 1
        samples = [times * sample for sample in record.parameters.get("samples_ms", [])]
        processes = [{**run, "median_ms": times * run["median_ms"], "plain_ms": run["plain_ms"] and times * run["plain_ms"]}
                     for run in record.parameters.get("processes", [])]
        return replace(record, median=times * record.median, low=times * record.low, high=times * record.high,
                       parameters={**record.parameters, "unsteady": [], "samples_ms": samples, **({"processes": processes} if processes else {})})

    machine.records = [scaled(record) for record in machine.records]
    return machine


def all_pairs(backend):
    return lambda record: record.table in ("scale", "step") and record.backend == backend
