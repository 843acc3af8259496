# SPDX-License-Identifier: MIT
"""What the extensions are worth by which OpenGL is tuned for NVIDIA's driver, all at once and one at a time."""
from paper.numbers.extensions import single, whole
from paper.numbers.ratios import LEGEND, texts
from paper.tables.tabular import Table
from paper.text import interval

CAPTION = ("What extensions are worth to OpenGL. Core: plain storage and no vendor's extension. Tuned: buffers of 2 MiB and more in "
           "memory of NVIDIA's driver, with large pages; sums through subgroups; the cell table read as a texture. Below, one of "
           f"these is left out. {LEGEND}")


def extensions(machine):
    all_at_once, alone = whole(machine), single(machine)
    both = all_at_once + alone
    ratios = texts([(row.core, row.tuned) for row in both])
    to_cuda = texts([(row.core, row.cuda) for row in all_at_once]) + ["-"] * len(alone)
    rows = [[row.what, f"{row.core.n:,}", interval(row.core, 1e3), interval(row.tuned, 1e3), row.cuda and interval(row.cuda, 1e3) or "-", *both_ratios]
            for row, *both_ratios in zip(both, ratios, to_cuda)]
    heads = [[("", 2), ("median [interval], µs", 3), ("time ratio of core to", 2)],
             ["work", "n", "core", "tuned", "CUDA", "tuned", "CUDA"]]
    sources = dict.fromkeys(record.source for row in both for record in (row.core, row.tuned))
    return Table("extensions", CAPTION, heads, rows, source=", ".join(sources))
