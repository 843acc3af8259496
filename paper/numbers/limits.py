# SPDX-License-Identifier: MIT
"""What limits the kernels of CUDA's searches, from the record of hardware counters."""
ISSUE, LOADS, MEMORY = "smsp__issue_active", "l1tex__data_pipe_lsu_wavefronts", "dram__cycles_active"
NAMES = {ISSUE: "issue slots", LOADS: "loads of L1", MEMORY: "memory", "lts__t_tag_requests": "tags of L2"}


def counters(machine):
    """One entry a kernel, size and order."""
    return machine.source("counters.json")["counters"]


def largest(rows):
    """Most spheres of the grid."""
    return max(row["n"] for row in rows if row["kernel"] == "collide_grid")
