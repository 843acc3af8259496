# SPDX-License-Identifier: MIT
"""A sweep of spherepair_bench can be shared out and taken up again. Usage: test_sweep.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
SMALL = ["--backends", "cpu", "--n", "64,128", "--blocks", "64", "--rounds", "1"]


def run(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True)


class Sweep(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name, "sweep")

    def sweep(self, *words):
        done = run(*SMALL, "--output", str(self.folder), *words)
        self.assertEqual(0, done.returncode, done.stderr)
        return done.stdout.splitlines()[-1]

    def files(self):
        return {path.name for path in self.folder.glob("*.json")}

    def test_shards_are_disjoint_and_cover_all(self):
        self.sweep("--shard", "1/2")
        first = self.files()
        self.sweep("--shard", "2/2")
        both = self.files()
        self.sweep()
        self.assertEqual(both, self.files())
        self.assertLess(0, len(first))
        self.assertLess(len(first), len(both))
        for name in both:
            rows = json.loads((self.folder / name).read_text())["benchmarks"]
            self.assertTrue(rows and all("error_occurred" not in row for row in rows))

    def test_resume_times_only_what_is_missing(self):
        self.sweep()
        kept = sorted(self.files())
        (self.folder / kept[0]).unlink()
        self.assertRegex(self.sweep("--resume"), f"^1 of {len(kept)} configurations timed, {len(kept) - 1} ")
        self.assertEqual(kept, sorted(self.files()))

    def test_bad_shards_are_refused(self):
        for shard in ("0/2", "3/2", "2", "1/-2", "a/b"):
            self.assertEqual(2, run(*SMALL, "--output", str(self.folder), "--shard", shard).returncode, shard)


if __name__ == "__main__":
    unittest.main()
