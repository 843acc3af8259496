# SPDX-License-Identifier: MIT
"""What figures and numbers derive from records: ratios, costs, slopes, shares of the instruction floor."""
import math

from records import Missing

INSTRUCTIONS = 4  # three fused multiply-adds and a comparison a pair, the least for the form that is used


def issue_rate(machine):
    """Lane-instructions a second: multiprocessors x 128 lanes x highest clock."""
    details = machine.backend("cuda")["details"]
    return float(details["multiprocessors"]) * 128 * float(details["highest clock MHz"]) * 1e6


def share_of_floor(machine, record):
    """Percent."""
    pairs = 0.5 * record.n * (record.n - 1)
    return 100 * pairs / (1e-3 * record.median) * INSTRUCTIONS / issue_rate(machine)


def slope(small, large):
    return math.log(large.median / small.median) / math.log(large.n / small.n)


def ratio(glsl, cuda):
    middle = glsl.median / cuda.median
    return middle, middle - glsl.low / cuda.high, glsl.high / cuda.low - middle


def matched(machine, **wanted):
    """(parameter record of GLSL, of CUDA) for every size both have."""
    if not (machine.has("glsl") and machine.has("cuda")):
        raise Missing(f"{machine.name} has no GLSL beside CUDA")
    glsl, cuda = (machine.need(backend=name, **wanted) for name in ("glsl", "cuda"))
    by_n = {record.n: record for record in cuda}
    return [(record, by_n[record.n]) for record in glsl if record.n in by_n]


def best(machine, name, method):
    n = max(record.n for record in machine.need(table="methods"))
    return min(machine.need(table="methods", backend=name, method=method, n=n), key=lambda record: record.median)


def cost(naive, exact):
    middle = exact.median / naive.median
    return [100 * (value - 1) for value in (middle, exact.low / naive.high, exact.high / naive.low)]


def pairs_of(machine):
    """(exact record, naive record), slowest first within each backend."""
    rows = [record for record in machine.need(table="exactness", exact=True)]
    n = max(record.n for record in rows)
    for exact in rows:
        if exact.n == n:
            yield exact, machine.one(table="exactness", exact=False, backend=exact.backend, method=exact.method, n=n)
