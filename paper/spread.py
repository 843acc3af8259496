# SPDX-License-Identifier: MIT
"""The spread of a timing in three layers: within a process, between processes on one GPU, and between GPUs.

A part of the recording runs in several processes. Their records become one: each time is the median of the processes'
medians, its interval that of the widest layer, and its 95th percentile that of all samples.
"""
import json
import math
import statistics
from collections import Counter

LAYERS = ("within", "processes", "gpus")
TIMED = ("measurements", "records", "frames", "times", "copies", "overlaps", "exactness", "contact_runs",
         "contact_sums", "gas_steps")  # lists of timings in records
OF_THE_TIMING = ("bounded_by_longest", "fits_l2", "pinned")  # what may be true of one process and not of another


def median_interval(samples, confidence=0.95):
    """The narrowest symmetric pair of order statistics with this coverage of the median; the whole range if none has it."""
    values, n = sorted(samples), len(samples)
    left_out = 0  # on each side
    while 2 * sum(math.comb(n, k) for k in range(left_out + 2)) <= (1 - confidence) * 2**n and 2 * left_out + 2 < n:
        left_out += 1
    return values[left_out], values[-1 - left_out]


def p95(samples):
    """The 95th percentile, linear between order statistics as in the program."""
    values = sorted(samples)
    below, rest = divmod(0.95 * (len(values) - 1), 1)
    low, high = values[int(below)], values[min(int(below) + 1, len(values) - 1)]
    return low + rest * (high - low)


def summary(row):
    """(median, low, high) in milliseconds, as recorded or from the samples."""
    samples = row.get("samples_ms")
    median = row["median_ms"] if "median_ms" in row else statistics.median(samples)
    low, high = row["interval_ms"] if "interval_ms" in row else median_interval(samples)
    return median, low, high


def spreads(runs):
    """layer -> (low, high) over the median, of (GPU, median, low, high) of each process; a layer with one entry has none."""
    by_gpu = {}
    for gpu, median, _, _ in runs:
        by_gpu.setdefault(gpu, []).append(median)
    lows, highs = ([run[end] / run[1] for run in runs] for end in (2, 3))
    found = {"within": (statistics.median(lows), statistics.median(highs))}
    of_gpus = [[end / statistics.median(medians) for end in median_interval(medians)]
               for medians in by_gpu.values() if len(medians) > 1]
    if of_gpus:
        found["processes"] = tuple(max(of_gpus, key=lambda ends: ends[1] - ends[0]))
    if len(by_gpu) > 1:
        medians = [statistics.median(medians) for medians in by_gpu.values()]
        middle = statistics.median(run[1] for run in runs)
        found["gpus"] = (min(*medians, middle) / middle, max(*medians, middle) / middle)
    return found


def merged_timing(runs, gpus):
    """One timing of those of several processes, on these GPUs by backend."""
    made = merged_value([{key: value for key, value in run.items() if key not in ("samples_ms", "interval_ms")}
                         for run in runs])
    ends = [(gpu.get(run.get("backend")), *summary(run)) for run, gpu in zip(runs, gpus)]
    middle, found = statistics.median(end[1] for end in ends), spreads(ends)
    low, high = max(found.values(), key=lambda layer: layer[1] - layer[0])
    stages = [run.get("device_stages_interval_ms", {}) for run in runs]
    samples = [sample for run in runs for sample in run["samples_ms"]]
    made |= {"median_ms": middle, "interval_ms": [low * middle, high * middle], "p95_ms": p95(samples), "spread": found,
             "samples_ms": samples,
             "processes": [{"gpu": end[0], "median_ms": end[1], "rounds": len(run["samples_ms"]),
                            **({"first_step_ms": run["first_step_ms"]} if "first_step_ms" in run else {})}
                           for run, end in zip(runs, ends)]}
    if any(stages):
        made["device_stages_interval_ms"] = {
            name: [min(of[name][0] for of in stages if name in of), max(of[name][1] for of in stages if name in of)]
            for name in dict.fromkeys(name for of in stages for name in of)}
    return made


def merged_value(values, gpus=None):
    """Timings are merged, other numbers become their median, the rest is the first process's."""
    first = values[0]
    if isinstance(first, dict) and gpus and "samples_ms" in first:
        return merged_timing(values, gpus)
    if isinstance(first, dict):
        kept = {}
        for key in dict.fromkeys(key for value in values for key in value):
            having = [k for k, value in enumerate(values) if key in value]
            kept[key] = merged_value([values[k][key] for k in having], gpus and [gpus[k] for k in having])
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


def merged_rows(lists, gpus):
    tables = [rows_by_identity(rows) for rows in lists]
    for key in dict.fromkeys(key for table in tables for key in table):
        having = [k for k, table in enumerate(tables) if key in table]
        yield merged_value([tables[k][key] for k in having], [gpus[k] for k in having])


def merged(roots):
    """The records of one command in several processes as one record."""
    gpus = [{backend["name"]: backend.get("uuid") or backend.get("device") for backend in root.get("backends", [])}
            for root in roots]
    rows = {name: list(merged_rows([root.get(name, []) for root in roots], gpus)) for name in TIMED if name in roots[0]}
    clocks = [moment for root in roots for moment in root.get("clocks", [])]
    return {**roots[0], **rows, **({"clocks": clocks} if clocks else {}), "processes": [
        {"commit": root.get("context", {}).get("build", {}).get("commit"), "gpus": sorted({gpu for gpu in of.values() if gpu})}
        for root, of in zip(roots, gpus)]}


def joined(roots):
    """The records of a sweep, or of a part of the catalogue each, as one record with all rows."""
    rows = {name: [row for root in roots for row in root.get(name, [])] for name in (*TIMED, "rows")
            if any(name in root for root in roots)}
    return {**roots[-1], **rows}
