# SPDX-License-Identifier: MIT
"""How far timings vary that were recorded in several processes: within a process, between processes, between GPUs."""
import statistics

from paper.numbers.layers import LAYERS, layers
from paper.records import Missing
from paper.tables.tabular import Table

VARIATION = ("How far timings vary, in percent of their medians: the width of the intervals within a process, the range of the "
             "medians of processes on one GPU, and the range of the medians of GPUs. Of all timings of a kind the median, in "
             "brackets the greatest. Processes: the least and the most of a timing. Intervals in this paper are not these ranges; "
             "they are t-intervals over processes.")
def cell(found, layer):
    widths = [each[layer] for each in found if layer in each]
    return f"{statistics.median(widths):.1f} ({max(widths):.1f})" if widths else "-"


def of_several(machine):
    return [record for record in machine.records if len(record.parameters.get("processes", ())) > 1]


def variation(machine):
    kinds = {}
    for record in of_several(machine):
        kinds.setdefault((record.table, "CPU" if record.backend == "cpu" else "GPU"), []).append(record)
    if not kinds:
        raise Missing(f"{machine.name} has no timing that was recorded in several processes")
    rows = []
    for (kind, device), records in sorted(kinds.items()):
        counts = {len(record.processes) for record in records}
        gpus = {run["gpu"] for record in records for run in record.processes} if device == "GPU" else ()
        found = [layers(record) for record in records]
        rows.append([kind.replace("_", " "), device, f"{len(records):,}", "-".join(map(str, sorted({min(counts), max(counts)}))),
                     str(len(gpus)) if gpus else "-", *(cell(found, layer) for layer in LAYERS)])
    heads = [[("", 5), ("spread, %", 3)],
             ["timings of", "on", "timings", "processes", "GPUs", "within one", "between processes", "between GPUs"]]
    runs = dict.fromkeys(record.source for records in kinds.values() for record in records)
    return Table("variation", VARIATION, heads, rows, left=2, source=", ".join(runs))
