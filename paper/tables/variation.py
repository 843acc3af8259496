# SPDX-License-Identifier: MIT
"""The spread of the timings that were recorded in several processes, layer by layer."""
import statistics

from paper.records import Missing
from paper.spread import LAYERS
from paper.tables.tabular import Table

VARIATION = ("How far timings vary, in percent of their medians: the width of their intervals within a process, the range "
             "of the medians between processes on one GPU, and between GPUs; of all timings of a kind the median, in "
             "brackets the greatest. Their intervals in this paper are those of the widest of the three.")


def width(record, layer):
    low, high = record.spread[layer]
    return 100 * (high - low)


def cell(records, layer):
    widths = [width(record, layer) for record in records if layer in record.spread]
    return f"{statistics.median(widths):.1f} ({max(widths):.1f})" if widths else "-"


def variation(machine):
    kinds = {}
    for record in machine.records:
        if "spread" in record.parameters:
            kinds.setdefault(record.table, []).append(record)
    if not kinds:
        raise Missing(f"{machine.name} has no timing that was recorded in several processes")
    rows = []
    for kind, records in sorted(kinds.items()):
        runs = [run for record in records for run in record.processes]
        gpus = {run["gpu"] for record in records if record.backend != "cpu" for run in record.processes}
        rows.append([kind.replace("_", " "), f"{len(records):,}", str(len(runs) // len(records)), str(len(gpus)),
                     *(cell(records, layer) for layer in LAYERS)])
    heads = [[("", 4), ("spread, %", 3)],
             ["timings of", "timings", "processes", "GPUs", "within one", "between processes", "between GPUs"]]
    runs = dict.fromkeys(record.source for records in kinds.values() for record in records)
    return Table("variation", VARIATION, heads, rows, source=", ".join(runs))
