# SPDX-License-Identifier: MIT
"""paper/counters reads the counters of each kernel from Nsight Compute's report and names the nearest limit."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

import stand_ins  # noqa: E402  (the path must be set first)
from paper.machine import hardware_counters  # noqa: E402
from paper.tools import Failed  # noqa: E402

PROGRAM = """#!{python}
import json, pathlib, sys
record = {{"context": {{"sources": {{}}}}, "backends": [{{"name": "cuda", "open": True}}]}}
pathlib.Path(sys.argv[sys.argv.index("--json") + 1]).write_text(json.dumps(record))
"""


GRID, ALL_PAIRS = hardware_counters.SEARCHES


class Reports(unittest.TestCase):
    def test_counters_of_each_kernel(self):
        bounds, grid = hardware_counters.entries_of("==PROF== noise\n" + stand_ins.report(), GRID, 1000, "warm")
        self.assertEqual(("grid_bounds", "collide_grid"), (bounds["kernel"], grid["kernel"]))
        self.assertEqual((12345, 71.5, 5e9, 1.7e9, 1060, 3, 40), tuple(grid[name] for name in (
            "time_ns", "issue_slots_percent", "instructions", "clock_hz", "instructions_per_warp", "launches", "registers")))
        self.assertEqual({"l1tex__data_pipe_lsu_wavefronts": 82.5, "smsp__issue_active": 71.5}, grid["limits"])
        self.assertEqual("l1tex__data_pipe_lsu_wavefronts", grid["nearest_limit"])
        self.assertEqual([("long_scoreboard", 4.5), ("wait", 1.5)], list(grid["stalls_per_issue"].items()))

    def test_medians_of_the_launches(self):
        self.assertEqual({"a": 2}, hardware_counters.medians([{"a": 1}, {"a": 2, "b": 1}, {"a": 9}]))

    def test_what_is_missing_is_named(self):
        without = {name: value for name, value in stand_ins.COUNTERS.items() if "lts" not in name}
        for text, search, message in (
                ("==ERROR== ERR_NVGPUCTRPERM", GRID, "no table of launches, it begins\n==ERROR== ERR_NVGPUCTRPERM"),
                (stand_ins.report(without), GRID, "did not tell lts__throughput"),
                (stand_ins.report(kernels=("grid_bounds",)), GRID, "no launch of collide_grid with 64 spheres, cold"),
                (stand_ins.report(kernels=("collide_grid",)), ALL_PAIRS, "no launch of collide_triangle with 64 spheres, cold")):
            with self.assertRaisesRegex(Failed, message):
                hardware_counters.entries_of(text, search, 64, "cold")


class Script(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = pathlib.Path(folder.name)
        program = self.home / "program"
        program.write_text(PROGRAM.format(python=sys.executable))
        program.chmod(0o755)

    def counted(self, environment, code):
        made = subprocess.run([sys.executable, ROOT / "paper/counters", self.home / "machine", "--program", self.home / "program"],
                              env=environment, capture_output=True, text=True)
        self.assertEqual(code, made.returncode, made.stderr)
        return made.stdout + made.stderr

    def test_it_records_every_search_kernel_size_and_order(self):
        report = stand_ins.report(kernels=("grid_bounds", "collide_grid", "collide_triangle"))
        output = self.counted(stand_ins.make_tools(self.home), 0)
        for search in (r"collide_grid +10000000", r"collide_triangle +1048576"):
            self.assertRegex(output, search + r" cold +12\.3 +72 +85 +45 +30  l1tex__data_pipe_lsu_wavefronts 82 %, "
                             r"smsp__issue_active 72 %; long_scoreboard 4\.5, wait 1\.5\n")
        record = json.loads((self.home / "machine/counters.json").read_text())
        self.assertEqual(2 * 2 * 2 + 1, len(record["counters"]))

    def test_a_profiler_that_fails_leaves_nothing_and_is_quoted(self):
        environment = stand_ins.make_tools(self.home)
        (self.home / "ncu").write_text("#!/bin/sh\necho ==ERROR== The user does not have permission; exit 1\n")
        self.assertRegex(self.counted(environment, 1), "left no report:\n==ERROR== The user does not have permission")
        self.assertFalse((self.home / "machine").exists())


if __name__ == "__main__":
    unittest.main()
