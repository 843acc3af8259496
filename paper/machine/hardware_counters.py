# SPDX-License-Identifier: MIT
"""Hardware counters of CUDA's searches, through the grid and of all pairs, by Nsight Compute: which limit their kernels
are nearest to."""
import csv
import json
import re
import statistics
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from paper.recording import devices_of
from paper.tools import Failed, output_of, required, version_of

PACKING_FRACTION = 0.3


@dataclass(frozen=True)
class Search:
    method: str  # also the kernel that searches
    kernels: tuple  # longer than 10 us
    sizes: tuple
    orders: tuple  # warm: spheres in cell order; cold: in random order
    skipped: int  # launches of these kernels: those of the check and of the warm-up
    profiled: int


SEARCHES = (
    Search("collide_grid", ("grid_bounds", "split_tiles", "split_count", "grid_split", "grid_sort", "collide_grid"),
           (1000000, 10000000), ("warm", "cold"), 12, 12),  # two to six steps
    Search("collide_triangle", ("collide_triangle",), (2**20,), ("cold",), 2, 3),
)
COUNTERS = {
    "time_ns": "gpu__time_duration.sum",
    "issue_slots_percent": "smsp__issue_active.avg.pct_of_peak_sustained_active",
    "instructions": "smsp__inst_executed.sum",  # of warps
    "clock_hz": "smsp__cycles_elapsed.avg.per_second",
    "instructions_per_warp": "smsp__average_inst_executed_per_warp.ratio",
    "occupancy_percent": "sm__warps_active.avg.pct_of_peak_sustained_active",
    "l1_percent": "l1tex__throughput.avg.pct_of_peak_sustained_active",
    "l2_percent": "lts__throughput.avg.pct_of_peak_sustained_elapsed",
    "dram_percent": "dram__throughput.avg.pct_of_peak_sustained_elapsed",
}
BREAKDOWNS = ("breakdown:sm__throughput.avg.pct_of_peak_sustained_elapsed",
              "breakdown:gpu__compute_memory_throughput.avg.pct_of_peak_sustained_elapsed")
LIMIT = re.compile(r"(?!\w*throughput|\w*warps_active)(\w+)\.(?:avg|sum|max)\.pct_of_peak_sustained_(?:elapsed|active)")
STALL = re.compile(r"smsp__average_warps_issue_stalled_(?!\w*not_issued)(\w+)_per_issue_active\.ratio")


def parsed(text):
    try:
        return float(text.replace(",", ""))
    except ValueError:
        return None


def rows_of(text):
    """(kernel, counter -> number) of each launch, of the raw page of a report as CSV; its second line has the units."""
    lines = text.splitlines()
    first = next((k for k, line in enumerate(lines) if line.startswith('"ID"')), None)
    if first is None:
        raise Failed("Nsight Compute's report has no table of launches, it begins\n" + "\n".join(lines[:12]))
    rows = list(csv.DictReader(lines[first:]))[1:]
    return [(row["Kernel Name"], {name: parsed(value) for name, value in row.items()
                                  if name and value and parsed(value) is not None}) for row in rows]


def medians(launches):
    names = set.intersection(*(set(launch) for launch in launches))
    return {name: statistics.median(launch[name] for launch in launches) for name in sorted(names)}


def descending(values):
    return dict(sorted(values.items(), key=lambda entry: -entry[1]))


def entry_of(name, launches):
    """Medians over the launches of one kernel; `limits` in percent of their peaks, the nearest first."""
    found = medians(launches)
    lacking = [counter for counter in COUNTERS.values() if counter not in found]
    if lacking:
        raise Failed(f"Nsight Compute did not tell {', '.join(lacking)} of {name}, but {', '.join(found)}")
    limits = {match[1]: value for counter, value in found.items() if (match := LIMIT.fullmatch(counter))}
    if not limits:
        raise Failed(f"Nsight Compute told no limit of {name}, but {', '.join(found)}")
    stalls = {match[1]: value for counter, value in found.items() if (match := STALL.fullmatch(counter))}
    return {**{short: found[counter] for short, counter in COUNTERS.items()},
            "registers": found.get("launch__registers_per_thread"), "launches": len(launches),
            "nearest_limit": max(limits, key=limits.get), "limits": descending(limits),
            "stalls_per_issue": descending({reason: value for reason, value in stalls.items() if reason != "selected"})}


def entries_of(text, search, n, order):
    by_name = {}
    for name, counters in rows_of(text):
        by_name.setdefault(name, []).append(counters)
    made = [{"kernel": kernel, "name": name, "backend": "cuda", "n": n, "order": order,
             "packing_fraction": PACKING_FRACTION, **entry_of(name, launches)}
            for kernel in search.kernels for name, launches in by_name.items() if re.search(rf"\b{kernel}\b", name)]
    if search.method not in (entry["kernel"] for entry in made):
        raise Failed(f"Nsight Compute saw no launch of {search.method} with {n} spheres, {order}, but "
                     f"{', '.join(by_name) or 'none'}")
    return made


def profiled(search, n, order, program):
    """Ends the program when the launches are profiled: the steps of a sweep do nothing but these searches."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder, "report.ncu-rep")
        words = [required("ncu"), "--export", report, "--clock-control", "none", "--cache-control", "none",
                 "--graph-profiling", "node", "--kernel-name", f"regex:{'|'.join(search.kernels)}",
                 "--launch-skip", search.skipped, "--launch-count", search.profiled, "--kill", "yes",
                 "--section", "WarpStateStats", "--section", "LaunchStats",
                 "--metrics", ",".join((*COUNTERS.values(), *BREAKDOWNS)), program, "sweep", "--backends", "cuda",
                 "--methods", search.method, "--packing-fractions", PACKING_FRACTION, "--rounds", 1,
                 "--n", n, "--orders", order, "--results", Path(folder, "sweep")]
        made = subprocess.run([str(word) for word in words], capture_output=True, text=True)
        if not report.exists():
            lines = (made.stdout + made.stderr).strip().splitlines()[-12:]
            raise Failed(f"`{' '.join(map(str, words))}` left no report:\n" + "\n".join(lines))
        return output_of("ncu", "--import", report, "--csv", "--page", "raw", "--print-units", "base")


def write_counters(folder, program):
    """FOLDER/counters.json. Returns its entries."""
    devices = devices_of(program)
    entries = [entry for search in SEARCHES for n in search.sizes for order in search.orders
               for entry in entries_of(profiled(search, n, order, program), search, n, order)]
    record = {"format": "spherepair counters 1", "context": devices["context"], "backends": devices["backends"],
              "tools": {"ncu": version_of("ncu")}, "counters": entries}
    folder.mkdir(parents=True, exist_ok=True)
    unfinished = folder / ".unfinished-counters.json"
    unfinished.write_text(json.dumps(record, indent=1) + "\n")
    unfinished.replace(folder / "counters.json")
    return entries
