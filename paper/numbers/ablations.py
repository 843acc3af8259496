# SPDX-License-Identifier: MIT
"""Ablations: the records of `spherepair ablate` and of drawing, in pairs of on and off."""
from paper.records import Missing

TABLE = "ablation"


def same_work(record):
    """The parameters that an on and an off record share, apart from the number of spheres."""
    scene = tuple(sorted((name, str(value)) for name, value in record.scene.items() if name != "n"))
    return record.option, record.backend, scene, record.parameters.get("method"), record.parameters.get("block")


def pairs_of(machine, table=TABLE):
    """(on, off) for every option, backend, scene and number of spheres, in the order of timing."""
    off = {(same_work(row), row.n): row for row in machine.select(table=table, on=False)}
    pairs = [(on, off[same_work(on), on.n]) for on in machine.need(table=table, on=True) if (same_work(on), on.n) in off]
    if not pairs:
        raise Missing(f"{machine.name} has no option that was timed on and off")
    return pairs
