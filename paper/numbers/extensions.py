# SPDX-License-Identifier: MIT
"""OpenGL as the standard has it, in plain storage and without vendors' extensions, beside OpenGL tuned for NVIDIA's driver."""
from dataclasses import dataclass

from paper.numbers.ablations import pairs_of
from paper.records import Missing, Record

NAMED = {"large_pages": "pages of 2 MiB", "subgroups": "subgroup sums", "texture_table": "cell table as a texture"}


@dataclass(frozen=True)
class Row:
    what: str
    core: Record  # without
    tuned: Record  # with
    cuda: Record  # None beside a single extension


def what_of(record):
    values = record.parameters
    if record.table == "core_grid":
        return "grid, " + {"cold": "random order", "warm": "cell order"}[values["order"]]
    return f"{values['work']}, {values['method']}"


def whole(machine):
    """All extensions at once: each work that was timed both ways and through CUDA, smallest n first."""
    found = {}
    for record in (record for table in ("core_grid", "core_motion") for record in machine.select(table=table)):
        found.setdefault((what_of(record), record.n), {})[record.backend] = record
    rows = [Row(what, *(each[name] for name in ("opengl-core", "opengl", "cuda"))) for (what, _), each in found.items()]
    if not rows:
        raise Missing(f"{machine.name} has no record of OpenGL without vendors' extensions")
    return rows


def single(machine):
    """One extension at a time, in random order."""
    return [Row(f"without {NAMED[on.option]}", off, on, None) for on, off in pairs_of(machine, "extension")]
