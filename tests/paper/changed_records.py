# SPDX-License-Identifier: MIT
"""The recorded machine, read once, and copies of it with the times of some records changed; its numbers, collected once."""
import copy
import pathlib
import sys
import unittest.mock
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper.numbers import macros  # noqa: E402  (the path must be set first)
from paper.records import APIS, DATA, MAIN, Machine  # noqa: E402

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


@lru_cache(maxsize=None)
def numbers():
    """Those of the paper, of every machine that it uses."""
    return macros.collect(recorded(), [recorded("llvmpipe")], three_apis())


@contextmanager
def laid_out_alone(but=""):
    """Figures are laid out without pixels and leave empty files; one is saved."""
    from matplotlib.figure import Figure
    save = Figure.savefig

    def lay_out(figure, file, **options):
        file = pathlib.Path(file)
        if file.stem == but:
            return save(figure, file, **options)
        if file.suffix == ".png":
            figure.draw_without_rendering()
        return file.touch()

    with unittest.mock.patch.object(Figure, "savefig", lay_out):
        yield
