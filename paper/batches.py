# SPDX-License-Identifier: MIT
"""The times of a step from the batches in a record, taken as the program takes them (bench/measure/samples.cpp). Older
records hold the same batches, but medians of rounds that late batches bend (docs/NOTES/measuring.md)."""
import statistics
from functools import lru_cache

import numpy

from paper.spread import median_interval, p95


@lru_cache
def pairs(count, sizes):
    """Of the batches of so many rounds those that are of different sizes, each with each."""
    first, second = numpy.triu_indices(count * sizes, 1)
    differ = first % sizes != second % sizes
    return first[differ], second[differ]


def least_deviations(steps, rounds):
    """(fixed cost, time of a step) by the line with the least sum of absolute deviations (Boscovich 1757): one through two
    of the batches, of several the mean."""
    x, y = numpy.tile(numpy.array(steps, float), len(rounds)), rounds.ravel()
    first, second = pairs(*rounds.shape)
    slopes = (y[second] - y[first]) / (x[second] - x[first])
    intercepts = y[first] - slopes * x[first]
    sums = numpy.abs(y - intercepts[:, None] - slopes[:, None] * x).sum(axis=1)
    nearest = sums <= sums.min() * (1 + 1e-9)
    return float(intercepts[nearest].mean()), float(slopes[nearest].mean())


@lru_cache(maxsize=None)
def times(steps, rounds):
    """The fields of a timing with these batches; None where longer ones took no longer. A round's time of a step is the
    median of its batches without the line's fixed cost, over their steps."""
    rounds, steps = numpy.array(rounds), numpy.array(steps)
    fixed, step = least_deviations(steps, rounds)
    if step <= 0:
        return None
    samples = numpy.median((rounds - fixed) / steps, axis=1).tolist()
    cost = float(numpy.median(numpy.median(rounds - step * steps, axis=1)))
    return {"samples_ms": samples, "median_ms": statistics.median(samples), "interval_ms": [*median_interval(samples)],
            "p95_ms": p95(samples), "min_ms": min(samples), "fixed_cost_us": 1e3 * cost,
            "fixed_cost_share": cost / statistics.median(rounds[:, -1].tolist())}


def fitted(row):
    """Any object of a record; a timing with batches of several sizes by their line."""
    steps = row.get("batches", ())
    found = times(tuple(steps), tuple(map(tuple, row["batch_ms"]))) if len(steps) > 1 else None
    return row | {name: value[:] if isinstance(value, list) else value for name, value in found.items()} if found else row
