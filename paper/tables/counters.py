# SPDX-License-Identifier: MIT
"""What limits the kernels of CUDA's searches, as a table."""
from paper.numbers.prose_limits import LOADS, NAMES
from paper.numbers.prose_limits import counters as recorded_counters
from paper.tables.tabular import Table

CAPTION = ("Hardware counters of CUDA's kernels, in percent of their peaks, medians of several launches, by Nsight Compute. Issue: slots "
           "in which an instruction was issued. Loads: the load pipe of L1. Warps: resident, of the most possible. "
           "OpenGL's kernels cannot be profiled in this way.")
ORDERS = {"warm": "cell", "cold": "random"}


def share(value):
    return f"{value:.0f}"


def counters(machine):
    rows = [[row["kernel"], f"{row['n']:,}", ORDERS[row["order"]], f"{1e-3 * row['time_ns']:,.0f}", share(row["issue_slots_percent"]),
             share(row["limits"][LOADS]), share(row["l2_percent"]), share(row["dram_percent"]), share(row["occupancy_percent"]),
             f"{NAMES.get(row['nearest_limit'], row['nearest_limit'])}, {share(row['limits'][row['nearest_limit']])}"]
            for row in recorded_counters(machine)]
    heads = [[("", 3), ("", 1), ("share of the peak, %", 5), ("", 1)],
             ["kernel", "spheres", "order", "µs", "issue", "loads", "L2", "memory", "warps", "nearest limit, %"]]
    return Table("counters", CAPTION, heads, rows, left=1, source=machine.source("counters.json")["id"])
