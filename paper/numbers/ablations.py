# SPDX-License-Identifier: MIT
"""On and off: the records of `spherepair skips` and of drawing, two by two."""
from records import Missing

TABLE = "skips"


def same_work(record):
    """What an on and an off record have in common, apart from the number of spheres."""
    scene = tuple(sorted((name, str(value)) for name, value in record.scene.items() if name != "n"))
    return record.skip, record.backend, scene, record.parameters.get("method"), record.parameters.get("block")


def pairs_of(machine):
    """(with, without) for every option, backend, scene and number of spheres, in the order in which they were timed."""
    without = {(same_work(row), row.n): row for row in machine.select(table=TABLE, on=False)}
    with_it = machine.need(table=TABLE, on=True)
    pairs = [(on, without[same_work(on), on.n]) for on in with_it if (same_work(on), on.n) in without]
    if not pairs:
        raise Missing(f"{machine.name} has no option that was timed both with and without")
    return pairs
