# SPDX-License-Identifier: MIT
"""The times of a step by a record's batches, as `bench/measure/samples.cpp` takes them from its own: records from before
that, of the same batches, say it by rounds that late batches bend (docs/NOTES/measuring.md)."""
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


def fitted(row):
    """Any object of a record; a timing with batches of several sizes by their line. A round's time of a step is the median of
    its batches without the line's fixed cost, over their steps."""
    steps = row.get("batches", ())
    if len(steps) < 2:
        return row
    rounds = numpy.array(row["batch_ms"])
    fixed, step = least_deviations(steps, rounds)
    if step <= 0:
        return row
    samples = numpy.median((rounds - fixed) / steps, axis=1).tolist()
    costs = numpy.median(rounds - step * numpy.array(steps), axis=1)
    return row | {"samples_ms": samples, "median_ms": statistics.median(samples), "interval_ms": [*median_interval(samples)],
                  "p95_ms": p95(samples), "min_ms": min(samples), "fixed_cost_us": 1e3 * float(numpy.median(costs)),
                  "fixed_cost_share": float(numpy.median(costs) / numpy.median(rounds[:, -1]))}
