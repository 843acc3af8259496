# SPDX-License-Identifier: MIT
"""OpenGL, Vulkan and CUDA on the same work."""
from paper.numbers import apis as three
from paper.numbers.ratios import LEGEND
from paper.tables.tabular import Table
from paper.text import APIS, ms


def apis(machine):
    rows = [[contest.work, *(ms(three.step_ms(record)) for record in contest.records), *(ratio.text for ratio in contest.ratios)]
            for contest in three.contests(machine)]
    sources = dict.fromkeys(record.source for contest in three.contests(machine) for record in contest.records)
    heads = [[("", 1), ("median, ms", 3), ("over CUDA", 2)], ["work", *(APIS[name] for name in three.APIS), "OpenGL", "Vulkan"]]
    return Table("apis", f"The same GLSL through OpenGL and Vulkan, and CUDA, each on its fastest path: medians, and the time ratios. {LEGEND}", heads, rows,
                 source=", ".join(sources))
