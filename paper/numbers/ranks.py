# SPDX-License-Identifier: MIT
"""Whether two timings differ. Contenders of a contest took their turns right behind each other in every round: the median
of the rounds' ratios and its interval say it, as in the program's tables; of several processes the widest of the spreads
within one, between them and between GPUs, which holds each process's median. What was not timed in turns has medians,
intervals and ranks."""
import math
import statistics
from functools import lru_cache

from paper.records import median_interval, steady
from paper.spread import spreads

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


def rounds_of(record):
    """How many each process has."""
    return [process["rounds"] for process in record.parameters.get("processes", ())] or [len(record.samples_ms)]


def paired(left, right):
    """They took their turns in one contest, in as many rounds of each process."""
    contest = left.parameters.get("contest")
    return (contest is not None and contest == right.parameters.get("contest") and left.source == right.source and
            rounds_of(left) == rounds_of(right))


def ratios(left, right):
    """Of the rounds that both took part in."""
    return [a / b for a, b in zip(left.samples_ms, right.samples_ms)]


def ratios_by_process(left, right):
    """(GPU, the median of the rounds' ratios, its lower and its upper bound) of each process."""
    of_rounds, found = ratios(left, right), []
    for process, rounds in zip(right.parameters.get("processes", ({"gpu": None},)), rounds_of(right)):
        own, of_rounds = of_rounds[:rounds], of_rounds[rounds:]
        found.append((process["gpu"], statistics.median(own), *median_interval(own)))
    return found


def time_ratio(left, right):
    """(left's time over right's, its lower and its upper bound)."""
    if not paired(left, right):
        return left.median / right.median, left.low / right.high, left.high / right.low
    runs = ratios_by_process(left, right)
    medians = [median for _, median, _, _ in runs]
    middle = statistics.median(medians)
    low, high = max(spreads(runs).values(), key=lambda layer: layer[1] - layer[0])
    return middle, min(low * middle, *medians), max(high * middle, *medians)


def apart(left, right):
    """The interval of their ratio is on one side of 1, or those of their medians do not overlap: required by the main
    claims."""
    _, low, high = time_ratio(left, right)
    return steady(left, right) and (low > 1 or high < 1)


def one_sided(left, right):
    """The interval of the rounds' ratios is on the side of 1 on which the ratio of the times is."""
    low, high = median_interval(ratios(left, right))
    return low > 1 if time_ratio(left, right)[0] > 1 else high < 1


def independent(record):
    """The medians of its processes, since samples of one process are alike, or of one process its samples."""
    return [run["median_ms"] for run in record.parameters.get("processes", ())] or record.samples_ms


def differ(left, right):
    return (steady(left, right) and min(len(left.samples_ms), len(right.samples_ms)) >= ENOUGH and
            one_sided(left, right) and (apart(left, right) or rank_test(independent(left), independent(right)) < 0.01))


def ratio_text(glsl, cuda, decided=differ):
    """GLSL's time over CUDA's with its interval, or that no difference is seen."""
    middle, low, high = time_ratio(glsl, cuda)
    return f"{middle:.2f}x [{low:.2f}, {high:.2f}]" if decided(glsl, cuda) else "no difference seen"
