# SPDX-License-Identifier: MIT
"""Whether two timings differ: the same rule as in the program's tables."""
import math
from functools import lru_cache

from paper.records import median_interval

ENOUGH = 6  # rounds, for an interval of 95 %


@lru_cache(maxsize=None)
def orders(left, right, u):
    """The number of orders of left and right distinct values with the Mann-Whitney statistic u."""
    if u < 0:
        return 0
    if left == 0 or right == 0:
        return int(u == 0)
    return orders(left - 1, right, u - right) + orders(left, right - 1, u)


def exact_p(a, b, u):
    low = min(u, a * b - u)
    tail = sum(orders(a, b, value) for value in range(int(low) + 1))
    return min(1.0, 2 * tail / math.comb(a + b, a))


def normal_p(a, b, u, ties):
    total = a + b
    variance = a * b / 12 * (total + 1 - sum(t**3 - t for t in ties) / (total * (total - 1)))
    if variance <= 0:
        return 1.0
    z = max(0.0, abs(u - a * b / 2) - 0.5) / math.sqrt(variance)
    return math.erfc(z / math.sqrt(2))


def rank_test(left, right):
    """Two-sided p of the Mann-Whitney rank test that both samples come from one distribution."""
    u = sum((x > y) + 0.5 * (x == y) for x in left for y in right)
    values = sorted([*left, *right])
    ties = [values.count(value) for value in set(values)]
    if max(ties) == 1 and max(len(left), len(right)) <= 40:
        return exact_p(len(left), len(right), u)
    return normal_p(len(left), len(right), u, ties)


def apart(left, right):
    """The intervals of the medians do not overlap: required by the main claims."""
    return left.high < right.low or right.high < left.low


def one_sided(left, right):
    """The interval of the rounds' ratios is on the side of 1 on which the ratio of the medians is."""
    low, high = median_interval([a / b for a, b in zip(left.samples_ms, right.samples_ms)])
    return low > 1 if left.median > right.median else high < 1


def independent(record):
    """The medians of its processes, since samples of one process are alike, or of one process its samples."""
    return [run["median_ms"] for run in record.parameters.get("processes", ())] or record.samples_ms


def differ(left, right):
    return (min(len(left.samples_ms), len(right.samples_ms)) >= ENOUGH and one_sided(left, right) and
            (apart(left, right) or rank_test(independent(left), independent(right)) < 0.01))


def verdict(glsl, cuda):
    if not differ(glsl, cuda):
        return "no difference seen"
    if cuda.median < glsl.median:
        return f"CUDA {100 * (1 - cuda.median / glsl.median):.1f} % faster"
    return f"GLSL {100 * (1 - glsl.median / cuda.median):.1f} % faster"
