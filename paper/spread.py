# SPDX-License-Identifier: MIT
"""Intervals of timings, and the records of several processes as one record.

A part of the recording runs in several processes, which are the independent observations: rounds of one process share its
memory layout, its clocks and its line through the batches. So a time of several processes is the median of the processes'
medians, with a t-interval of their logarithms. A time of one process has an interval over its rounds, which says nothing
of other processes.
"""
import json
import math
import statistics
from collections import Counter
from functools import lru_cache

import numpy
from scipy import stats

TIMED = ("measurements", "records", "frames", "times", "copies", "overlaps", "exactness", "contact_runs",
         "contact_sums", "gas_steps")  # lists of timings in records
OF_THE_TIMING = ("bounded_by_longest", "fits_l2", "pinned", "checked_against")  # what processes may differ in
CONFIDENCE = 0.95


@lru_cache(maxsize=None)
def left_out(count):
    """The most order statistics of so many samples that an interval of the median may leave out on each side."""
    return max(0, int(stats.binom.ppf((1 - CONFIDENCE) / 2, count, 0.5)) - 1)


def median_interval(samples):
    """The narrowest symmetric pair of order statistics that covers the median; the whole range if none has the coverage."""
    values, out = sorted(samples), left_out(len(samples))
    return values[out], values[-1 - out]


def p95(samples):
    """The 95th percentile, linear between order statistics as in the program."""
    return float(numpy.quantile(samples, 0.95))


def summary(row):
    """(median, low, high) in milliseconds, as recorded or from the samples."""
    samples = row.get("samples_ms")
    median = row["median_ms"] if "median_ms" in row else statistics.median(samples)
    low, high = row["interval_ms"] if "interval_ms" in row else median_interval(samples)
    return median, low, high


@lru_cache(maxsize=None)
def quantile(freedom):
    return float(stats.t.ppf((1 + CONFIDENCE) / 2, freedom))


def t_interval(values):
    """Low and high end of the t-interval of the values' logarithms; the values are independent and at least two."""
    if len(set(values)) == 1:  # without the rounding of their logarithms
        return values[0], values[0]
    logs, count = [math.log(value) for value in values], len(values)
    mean = math.fsum(logs) / count
    variance = math.fsum((value - mean)**2 for value in logs) / (count - 1)
    half = quantile(count - 1) * math.sqrt(variance / count)
    return math.exp(mean - half), math.exp(mean + half)


def interval(values, of_one):
    """Over processes, one value each; of one process the interval of its rounds."""
    return t_interval(values) if len(values) > 1 else of_one


def plain_mean(row):
    """Milliseconds a step as the mean of the longest batches, without a fitted line; None without batches."""
    rounds = row.get("batch_ms")
    return math.fsum(batches[-1] for batches in rounds) / len(rounds) / row["batches"][-1] if rounds else None


def process_of(run, number, gpu):
    """What a timing keeps of each of its processes."""
    median, low, high = summary(run)
    kept = {name: run[name] for name in ("first_step_ms", "device_stages_ms") if name in run}
    return {"process": number, "gpu": gpu, "median_ms": median, "interval_ms": [low, high], "plain_ms": plain_mean(run),
            "rounds": len(run["samples_ms"]), **kept}


def stage_intervals(runs):
    """Kernel -> interval of its device time, over the processes that timed it."""
    timed = {}
    for run in runs:
        for name, ends in run.get("device_stages_interval_ms", {}).items():
            timed.setdefault(name, []).append((run["device_stages_ms"][name], ends))
    return {name: list(interval([time for time, _ in found], found[0][1]) if all(time > 0 for time, _ in found) else (0, 0))
            for name, found in timed.items()}


def merged_timing(runs, origins):
    """One timing of those of several processes; an origin is a process's number and its GPU by backend."""
    made = merged_value([{key: value for key, value in run.items() if key not in ("samples_ms", "interval_ms", "batch_ms")}
                         for run in runs])
    processes = [process_of(run, number, gpus.get(run.get("backend"))) for run, (number, gpus) in zip(runs, origins)]
    medians, samples = [each["median_ms"] for each in processes], [sample for run in runs for sample in run["samples_ms"]]
    made |= {"median_ms": statistics.median(medians), "interval_ms": list(interval(medians, processes[0]["interval_ms"])),
             "p95_ms": p95(samples), "samples_ms": samples, "processes": processes}
    stages = stage_intervals(runs)
    return made | ({"device_stages_interval_ms": stages} if stages else {})


def merged_value(values, origins=None):
    """Timings are merged, other numbers become their median, the rest is the first process's."""
    first = values[0]
    if isinstance(first, dict) and origins and "samples_ms" in first:
        return merged_timing(values, origins)
    if isinstance(first, dict):
        kept = {}
        for key in dict.fromkeys(key for value in values for key in value):
            having = [k for k, value in enumerate(values) if key in value]
            kept[key] = merged_value([values[k][key] for k in having], origins and [origins[k] for k in having])
        return kept
    numbers = all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in values)
    return statistics.median(values) if numbers and len(set(values)) > 1 else first


def identity(row):
    """What tells a row from others, whichever process it is of."""
    return json.dumps({key: value for key, value in row.items()
                       if key in ("n", "block", "k", "dt", "scene") or
                       isinstance(value, (str, bool)) and key not in OF_THE_TIMING}, sort_keys=True)


def rows_by_identity(rows):
    """(identity, how often it came before) -> row."""
    seen, found = Counter(), {}
    for row in rows:
        key = identity(row)
        found[key, seen[key]] = row
        seen[key] += 1
    return found


def merged_rows(lists, origins):
    tables = [rows_by_identity(rows) for rows in lists]
    for key in dict.fromkeys(key for table in tables for key in table):
        having = [k for k, table in enumerate(tables) if key in table]
        yield merged_value([tables[k][key] for k in having], [origins[k] for k in having])


def merged(roots):
    """The records of one command in several processes as one record."""
    gpus = [{backend["name"]: backend.get("uuid") or backend.get("device") for backend in root.get("backends", [])}
            for root in roots]
    rows = {name: list(merged_rows([root.get(name, []) for root in roots], list(enumerate(gpus, 1)))) for name in TIMED
            if name in roots[0]}
    clocks = [moment for root in roots for moment in root.get("clocks", [])]
    return {**roots[0], **rows, **({"clocks": clocks} if clocks else {}), "processes": [
        {"commit": root.get("context", {}).get("build", {}).get("commit"), "gpus": sorted({gpu for gpu in of.values() if gpu})}
        for root, of in zip(roots, gpus)]}


def joined(roots):
    """The records of a sweep, or of a part of the catalogue each, as one record with all rows."""
    rows = {name: [row for root in roots for row in root.get(name, [])] for name in (*TIMED, "rows")
            if any(name in root for root in roots)}
    return {**roots[-1], **rows}
