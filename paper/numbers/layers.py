# SPDX-License-Identifier: MIT
"""How far the times of one work lie apart within a process, between processes on one GPU, and between GPUs."""
import statistics

LAYERS = ("within", "processes", "gpus")


def spread(values, middle):
    return 100 * (max(values) - min(values)) / middle


def layers(record):
    """layer -> percent, of those that the timing has."""
    by_gpu = {}
    for run in record.processes:
        by_gpu.setdefault(run["gpu"], []).append(run["median_ms"])
    found = {"within": statistics.median(spread(run["interval_ms"], run["median_ms"]) for run in record.processes)}
    repeated = [spread(medians, record.median) for medians in by_gpu.values() if len(medians) > 1]
    if repeated:
        found["processes"] = max(repeated)
    if len(by_gpu) > 1:
        found["gpus"] = spread([statistics.median(medians) for medians in by_gpu.values()], record.median)
    return found
