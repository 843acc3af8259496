# SPDX-License-Identifier: MIT
"""The time of a step by the line through all batches: late ones do not bend it, and the program has the same.
Usage: test_batches.py SPHEREPAIR"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
PROGRAM = sys.argv.pop(1)

import numpy  # noqa: E402  (the path must be set first)

from paper import batches  # noqa: E402
from paper.records import DATA, MAIN  # noqa: E402

STEPS, FIXED, STEP = (250, 500, 1000), 0.06, 0.02  # ms


def timing(late=(), scatter=0.0):
    """Eleven rounds; late: (round, batch) that takes 1.5 ms longer."""
    noise = random.Random(1)
    rounds = [[FIXED + STEP * steps + scatter * noise.gauss(0, 1) + 1.5 * ((k, size) in late)
               for size, steps in enumerate(STEPS)] for k in range(11)]
    return {"batches": list(STEPS), "batch_ms": rounds, "median_ms": 0, "samples_ms": []}


class Line(unittest.TestCase):
    def check(self, row, tolerance, microseconds=1e-6):
        found = batches.fitted(row)
        self.assertEqual(11, len(found["samples_ms"]))
        for end in (found["median_ms"], *found["interval_ms"]):
            self.assertAlmostEqual(STEP, end, delta=tolerance * STEP)
        self.assertAlmostEqual(1e3 * FIXED, found["fixed_cost_us"], delta=microseconds)
        self.assertAlmostEqual(FIXED / (FIXED + STEP * STEPS[-1]), found["fixed_cost_share"], delta=1e-3)

    def test_undisturbed_batches(self):
        self.check(timing(), 1e-9)

    def test_late_batches_do_not_bend_it(self):
        """The shortest batches of seven rounds are late: least squares makes most rounds' steps 7 % too short."""
        late = {(k, 0) for k in range(7)} | {(8, 1), (9, 2)}
        bent = [numpy.polyfit(STEPS, batch, 1)[0] for batch in timing(late)["batch_ms"]]
        self.assertLess(numpy.median(bent), 0.95 * STEP)
        self.check(timing(late), 1e-9)
        self.check(timing(late, scatter=0.01), 2e-3, microseconds=20)

    def test_no_other_line_is_nearer(self):
        rounds = numpy.array(timing({(0, 0), (1, 0), (2, 2)}, scatter=0.05)["batch_ms"])

        def deviations(fixed, step):
            return numpy.abs(rounds - fixed - step * numpy.array(STEPS)).sum()

        fixed, step = batches.least_deviations(STEPS, rounds)
        for more in (-1e-3, 0, 1e-3):
            for longer in (-1e-6, 0, 1e-6):
                self.assertLessEqual(deviations(fixed, step), deviations(fixed + more, step + longer))

    def test_batches_of_one_size_and_other_objects_stay(self):
        for row in ({"batches": [4], "batch_ms": [[1.0]], "median_ms": 0.25}, {"n": 64}):
            self.assertIs(row, batches.fitted(row))


class Records(unittest.TestCase):
    def test_processes_agree_where_batches_came_late(self):
        """OpenGL's collide_tiled of 512 spheres, by the program and here. Each round fitted by itself: 3 % apart."""
        def medians(hook):
            for path in sorted((DATA / MAIN / "results").glob("*.json")):
                for row in json.loads(path.read_text(), object_hook=hook)["measurements"]:
                    if (row["table"], row["label"], row.get("n")) == ("table1", "glsl collide_tiled 128", 512):
                        yield row["median_ms"]

        for hook in (None, batches.fitted):
            found = list(medians(hook))
            self.assertEqual(5, len(found))
            self.assertLessEqual(max(found) / min(found), 1.01)

    def test_the_program_has_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "crossover", "--backends", "cpu", "--n", "100,1000", "--kinds", "gas", "--rounds", "7",
                            "--results", folder], check=True, capture_output=True)
            rows = json.loads(pathlib.Path(folder, "crossover.json").read_text())["measurements"]
        self.assertLess(4, len(rows))
        for row in rows:
            self.assertEqual((3, 7), (len(row["batches"]), row["fixed_cost_fitted"]))
            found = batches.fitted(row)
            self.assertIsNot(row, found)
            for name in ("samples_ms", "interval_ms", "median_ms", "p95_ms", "min_ms", "fixed_cost_us", "fixed_cost_share"):
                numpy.testing.assert_allclose(found[name], row[name], rtol=1e-6, atol=1e-9, err_msg=f"{row['label']} {name}")


if __name__ == "__main__":
    unittest.main()
