# SPDX-License-Identifier: MIT
"""OpenGL, Vulkan and CUDA on the same work."""
from paper.numbers import apis as three
from paper.numbers.ratios import LEGEND
from paper.records import recorded_code
from paper.tables.tabular import Table
from paper.text import APIS, ms


def apis(machine):
    rows = [[contest.work, *(ms(three.step_ms(record)) for record in contest.records), *(ratio.text for ratio in contest.ratios)]
            for contest in three.contests(machine)]
    sources = dict.fromkeys(record.source for contest in three.contests(machine) for record in contest.records)
    heads = [[("", 1), ("median, ms", 3), ("over CUDA", 2)], ["work", *(APIS[name] for name in three.APIS), "OpenGL", "Vulkan"]]
    return Table("apis", f"The same GLSL through OpenGL and Vulkan, and CUDA, each on its fastest path: medians, and the time ratios. {LEGEND}", heads, rows,
                 source=", ".join(sources))


def opening(machine):
    uses, compiling, code = three.first_uses(machine), three.compile_seconds(machine), recorded_code()["host"]

    def row(what, key, scale=1):
        return [what, *(ms(uses[name][key] and uses[name][key] / scale) for name in three.APIS)]
    rows = [row("opening the API, ms", "open_ms"), row("first search of a million spheres, ms", "first_search_ms"),
            row("a later search, ms", "later_search_ms"), ["compiling all kernels, s", *(ms(compiling.get(name)) for name in three.APIS)],
            row("host memory, MB: open", "opened_host_bytes", 1e6), row("searching", "host_bytes", 1e6),
            row("GPU memory, MB: open", "opened_gpu_bytes", 1e6), row("searching", "gpu_bytes", 1e6),
            ["lines of host code", *(f"{code[name]:,}" for name in three.APIS)]]
    sources = [machine.source(f"first_use_{name}.json")["id"] for name in three.APIS] + [machine.source("compile.json")["id"]]
    heads = [[("", 1)] * 4, ["", *(APIS[name] for name in three.APIS)]]
    return Table("opening", "What an API costs before it is fast, each in a process of its own and without the driver's cache of kernels. A search "
                 "is waited for. Compiling: by the driver, in Vulkan also by glslang; CUDA's kernels are compiled when the program is built. Memory: "
                 "the growth of the process and, by NVML, of the GPU.", heads, rows, source=", ".join(sources))
