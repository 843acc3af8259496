# SPDX-License-Identifier: MIT
"""A sweep can be taken up again, and Google Benchmark times what is checked. Usage: test_sweep.py SPHEREPAIR [SPHEREPAIR_BENCH]"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, BENCH = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
del sys.argv[1:3]


class Sweep(unittest.TestCase):
    SMALL = [PROGRAM, "sweep", "--backends", "cpu", "--n", "200,1000", "--packing-fractions", "0.3", "--rounds", "1"]
    OF_ONE_SIZE = [word.replace("200,1000", "200") for word in SMALL]

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name, "sweep")

    def run_it(self, *words):
        return subprocess.run([*self.SMALL, "--results", str(self.folder), *words], capture_output=True, text=True)

    def sweep(self, *words):
        done = self.run_it(*words)
        self.assertEqual(0, done.returncode, done.stderr)
        warning = ("* ", "  ")  # of a busy machine, as one that runs tests is
        return [line for line in done.stdout.splitlines() if not line.startswith(warning)][-1]

    def files(self):
        return {path.name for path in self.folder.glob("*.json")}

    def test_a_file_holds_a_configuration(self):
        self.sweep()
        self.assertEqual(4, len(self.files()))
        self.check_records([json.loads((self.folder / name).read_text()) for name in self.files()])

    def test_resume_times_only_what_is_missing(self):
        self.SMALL = self.OF_ONE_SIZE
        self.sweep()
        kept = sorted(self.files())
        (self.folder / kept[0]).unlink()
        self.assertRegex(self.sweep("--resume"), f"^1 of {len(kept)} configurations timed, {len(kept) - 1} ")
        self.assertEqual(kept, sorted(self.files()))

    def test_resume_times_again_what_is_no_whole_record(self):
        self.SMALL = self.OF_ONE_SIZE
        self.sweep()
        name = sorted(self.files())[0]
        whole = (self.folder / name).read_text()
        for text in ("", whole[:len(whole) // 2], "[]", '{"format": "another"}'):
            (self.folder / name).write_text(text)
            self.assertRegex(self.sweep("--resume"), "^1 of ", text)
            self.assertEqual(json.loads(whole).keys(), json.loads((self.folder / name).read_text()).keys())


    def check_records(self, roots):
        rows = [row for root in roots for row in root["measurements"]]
        self.assertEqual({("cold", "sequential"), ("cold", "parallel"), ("cold", "collide_group"),
                          ("cold", "collide_grid"), ("warm", "collide_grid")},
                         {(row["order"], row["method"]) for row in rows})
        self.assertTrue(all(root["context"]["build"]["commit"] for root in roots))
        for n in (200, 1000):  # the set does not depend on the method, nor its size on the order of the spheres
            found = [row for row in rows if row["n"] == n and row["method"] != "collide_group"]
            self.assertEqual(1, len({row["pairs"] for row in found}))
            self.assertLess(0, found[0]["pairs"])
            self.assertEqual(1, len({row["fingerprint"] for row in found if row["order"] == "cold"}))

    def test_what_is_not_timed_is_named(self):
        self.SMALL = [PROGRAM, "sweep", "--backends", "cpu", "--n", "20000", "--packing-fractions", "0.3", "--rounds",
                      "1", "--orders", "cold", "--methods", "sequential,collide_grid"]
        self.sweep()
        (root,) = [json.loads(path.read_text()) for path in self.folder.glob("*.json")]
        self.assertEqual(["collide_grid"], [row["method"] for row in root["measurements"]])
        self.assertEqual(["sequential"], [row["method"] for row in root["left_out"]])


@unittest.skipUnless(BENCH, "spherepair_bench was not built: Google Benchmark is missing")
class OfGoogleBenchmark(unittest.TestCase):
    def test_each_row_is_checked_and_timed(self):
        done = subprocess.run([BENCH, "--backends", "cpu", "--n", "64,128", "--blocks", "64", "--rounds", "2",
                               "--benchmark_format=json"], capture_output=True, text=True)
        self.assertEqual(0, done.returncode, done.stderr)
        rows = json.loads(done.stdout)["benchmarks"]
        self.assertTrue(all("error_occurred" not in row for row in rows))
        self.assertLessEqual({f"cpu/{work}/random/n:{n}" for work in ("move", "step", "parallel") for n in (64, 128)},
                             {row["run_name"].split("/iterations")[0] for row in rows})


if __name__ == "__main__":
    unittest.main()
