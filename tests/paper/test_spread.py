# SPDX-License-Identifier: MIT
"""Records of several processes become one: median of the medians, interval of the widest layer of spread. What was
recorded in pieces is read as a whole."""
import json
import pathlib
import statistics
import sys
import tempfile
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper import spread  # noqa: E402  (the path must be set first)
from paper.numbers import prose_equality, ranks  # noqa: E402
from paper.records import DATA, MAIN, Machine, Missing, Record  # noqa: E402


def timing(middle, within=0.01, **parameters):
    samples = [middle * (1 - within), middle, middle * (1 + within)]
    return {"table": "grid", "backend": "cuda", "label": "cuda collide_grid", "n": 1024, "batch": int(1e3 / middle),
            "scene": {"name": "uniform", "packing_fraction": 0.3}, "samples_ms": samples, "median_ms": middle,
            "interval_ms": [samples[0], samples[2]], "device_stages_ms": {"collide_grid": middle},
            "device_stages_interval_ms": {"collide_grid": [samples[0], samples[2]]}, **parameters}


def record(*rows, gpu="A", **more):
    return {"context": {"date": "2026", "sources": {"measure": gpu}}, "measurements": list(rows),
            "backends": [{"name": "cuda", "open": True, "device": "H200", "uuid": gpu}], **more}


class Layers(unittest.TestCase):
    def merged(self, middles, gpus="AAAAA", within=0.01):
        roots = [record(timing(middle, within), gpu=gpu) for middle, gpu in zip(middles, gpus)]
        return spread.merged(roots)["measurements"][0]

    def check(self, row, layer, low, high):
        widest = max(row["spread"], key=lambda name: row["spread"][name][1] - row["spread"][name][0])
        self.assertEqual(layer, widest)
        self.assertAlmostEqual(low, row["interval_ms"][0])
        self.assertAlmostEqual(high, row["interval_ms"][1])

    def test_processes_that_agree_leave_the_interval_of_one(self):
        row = self.merged([10, 10, 10.01, 10, 9.99])
        self.assertEqual(10, row["median_ms"])
        self.check(row, "within", 9.9, 10.1)

    def test_processes_that_differ_widen_it(self):
        row = self.merged([10, 8, 12, 11, 10])
        self.assertEqual(10, row["median_ms"])
        self.check(row, "processes", 8, 12)
        self.assertNotIn("gpus", row["spread"])

    def test_gpus_that_differ_widen_it(self):
        row = self.merged([10, 10, 10, 13, 13], gpus="AAABB")
        self.check(row, "gpus", 10, 13)
        self.assertEqual((1, 1), row["spread"]["processes"])  # on one GPU they agree

    def test_one_process_on_each_gpu_tells_nothing_of_processes(self):
        self.assertEqual({"within", "gpus"}, set(self.merged([10, 11], gpus="AB")["spread"]))

    def test_all_samples_and_stages_are_kept(self):
        row = self.merged([10, 12])
        self.assertEqual(6, len(row["samples_ms"]))
        self.assertAlmostEqual(12 + 0.75 * 0.12, row["p95_ms"])
        self.assertEqual([10, 12], [run["median_ms"] for run in row["processes"]])
        low, high = row["device_stages_interval_ms"]["collide_grid"]
        self.assertAlmostEqual(9.9, low)
        self.assertAlmostEqual(12.12, high)
        self.assertEqual(11, row["device_stages_ms"]["collide_grid"])


class Rows(unittest.TestCase):
    def test_the_mark_of_one_process_stays(self):
        roots = [record(timing(1)), record(timing(1, unsteady=["its interval is wider than 2x"]))]
        rows = spread.merged(roots)["measurements"]
        self.assertEqual(["its interval is wider than 2x"], [reason for row in rows for reason in row["unsteady"]])

    def test_the_same_rows_are_merged_in_any_order(self):
        small, large = timing(1), timing(5, n=4096)
        rows = spread.merged([record(small, large), record(large, small)])["measurements"]
        self.assertEqual([(1024, 1), (4096, 5)], [(row["n"], row["median_ms"]) for row in rows])

    def test_what_the_timing_says_of_itself_is_no_other_row(self):
        roots = [record(timing(10, bounded_by_longest=longest, pinned=longest, fits_l2=longest)) for longest in (True, False)]
        self.assertEqual(1, len(spread.merged(roots)["measurements"]))

    def test_rows_that_only_some_processes_have_stay(self):
        rows = spread.merged([record(timing(1)), record(timing(1), timing(5, n=4096))])["measurements"]
        self.assertEqual([2, 1], [len(row["processes"]) for row in rows])

    def test_rows_with_the_same_names_are_told_apart_by_their_order(self):
        rows = spread.merged([record(timing(1), timing(5)), record(timing(3), timing(7))])["measurements"]
        self.assertEqual([2, 6], [row["median_ms"] for row in rows])

    def test_numbers_without_samples_become_their_median(self):
        roots = [record(overlaps=[{"transfer": "host", "n": 64, "frame_ms": value}]) for value in (1, 5, 2)]
        self.assertEqual([{"transfer": "host", "n": 64, "frame_ms": 2}], spread.merged(roots)["overlaps"])


class Folders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name, "machine")

    def write(self, name, root):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(root))

    def test_processes_of_a_command_and_of_a_sweep(self):
        for k, middle in enumerate((10, 12, 11), 1):
            self.write(f"results/{k}.json", record(timing(middle, table="step"), gpu=f"GPU {k}"))
            for n in (64, 1024):
                self.write(f"sweep/{k}/grid-{n}.json", record(timing(middle, n=n)))
        machine = Machine(self.folder)
        self.assertEqual(11, machine.one(table="step").median)
        self.assertEqual(3, len(machine.one(table="step").recorded))
        self.assertEqual([(64, 11, True), (1024, 11, True)],
                         [(row.n, row.median, row.swept) for row in machine.select(table="grid")])

    def test_one_file_stays_as_it_is(self):
        self.write("results.json", record(timing(10, table="step")))
        self.assertNotIn("spread", Machine(self.folder).one(table="step").parameters)

    def test_one_file_and_processes_of_the_same_name_are_refused(self):
        self.write("results.json", record())
        self.write("results/1.json", record())
        with self.assertRaisesRegex(Missing, "results.json"):
            Machine(self.folder)

    def test_a_part_that_is_being_recorded_is_not_read(self):
        self.write("results.json", record())
        self.write(".results-1/results.json", record(timing(10, table="step")))
        self.assertEqual([], Machine(self.folder).records)

    def test_rows_of_the_catalogue_are_joined(self):
        self.write("results.json", record())
        for k, name in enumerate(("rows-0-1", "rows-2-3")):
            self.write(f"stress/{name}.json", {"format": "spherepair stress 1", "rows": [{"row": k}]})
        self.assertEqual([{"row": 0}, {"row": 1}], Machine(self.folder).source("stress.json")["rows"])

    def test_recorded_folders_are_read_as_before(self):
        self.assertLess(1000, len(Machine(DATA / MAIN).records))


class Batches(unittest.TestCase):
    """What the study says of its method: K is so large that a batch's fixed cost is below 0.5 % in the median."""

    def test_what_a_batch_costs_besides_its_steps_is_under_half_a_percent(self):
        machine = Machine(DATA / MAIN)
        for part in ("results.json", "sweep", "launches.json", "ablate.json", "frame_rates.json", "precision_float32.json"):
            of_part = [record for record in machine.records if record.source == machine.source(part)["id"]]
            for api in ("glsl", "cuda"):
                shares = [100 * abs(record.fixed_cost_share) for record in of_part
                          if record.backend == api and record.parameters.get("fixed_cost_share") is not None]
                self.assertGreater(len(shares), 25, f"{part} {api}")
                self.assertLess(statistics.median(shares), prose_equality.AIM, f"{part} {api}")


class Tests(unittest.TestCase):
    """The number of passed tests, of one output or of several shards."""

    def passed(self, **texts):
        with tempfile.TemporaryDirectory() as folder:
            for name, (shard, count) in texts.items():
                path = pathlib.Path(folder, name.replace("__", "/") + ".txt")
                path.parent.mkdir(exist_ok=True)
                path.write_text(f"Note: This is test shard {shard} of 2.\n[  PASSED  ] {count} tests.\n" if shard
                                else f"[  PASSED  ] {count} tests.\n")
            machine, found = types.SimpleNamespace(name="made up", folder=pathlib.Path(folder)), {}
            prose_equality.tests(lambda key, text, source, how: found.update({key: text}), machine, [])
        return found["tests/passed"]

    def test_all_shards_count_and_none_may_be_absent(self):
        self.assertEqual("7", self.passed(tests=(0, 7)))
        self.assertEqual("7", self.passed(tests__1=(1, 3), tests__2=(2, 4)))
        for lacking in ({"tests__1": (1, 3)}, {}):
            with self.assertRaises(Missing):
                self.passed(**lacking)


class Ratios(unittest.TestCase):
    """Of the turns of several processes: an interval that pools their rounds would be too narrow."""

    def ratio(self, factors):
        roots = [record(timing(10 * factor, backend="glsl"), timing(10)) for factor in factors]
        glsl, cuda = (Record({**row, "contest": "made up"}, *spread.summary(row), "made up")
                      for row in spread.merged(roots)["measurements"])
        self.assertTrue(ranks.paired(glsl, cuda))
        return ranks.time_ratio(glsl, cuda), ranks.apart(glsl, cuda)

    def test_the_interval_holds_every_process(self):
        (middle, low, high), apart = self.ratio([1.2, 1.3, 1.4, 1.1, 0.95])
        self.assertAlmostEqual(1.2, middle)
        self.assertLessEqual(low, 0.95)
        self.assertGreaterEqual(high, 1.4)
        self.assertFalse(apart)

    def test_processes_that_lack_one_of_them_are_no_pairs(self):
        """Their rounds would be those of others."""
        roots = [record(timing(10, backend="glsl"), timing(10)), record(timing(20, backend="glsl"))]
        glsl, cuda = (Record({**row, "contest": "made up"}, *spread.summary(row), "made up")
                      for row in spread.merged(roots)["measurements"])
        self.assertFalse(ranks.paired(glsl, cuda))

    def test_a_lead_in_every_process_is_one(self):
        (middle, low, high), apart = self.ratio([1.2, 1.3, 1.4, 1.1, 1.15])
        self.assertAlmostEqual(1.2, middle)
        self.assertTrue(1 < low <= 1.1 and 1.4 <= high)
        self.assertTrue(apart)


class Ranks(unittest.TestCase):
    """Samples of one process are not independent, so that many of them decide nothing."""

    def contest(self, glsl, cuda):
        roots = [record(timing(left, backend="glsl"), timing(right)) for left, right in zip(glsl, cuda)]
        rows = [Record(row, *spread.summary(row), "made up") for row in spread.merged(roots)["measurements"]]
        return ranks.differ(*rows)

    def test_processes_decide(self):
        self.assertTrue(self.contest([10.3, 10.4, 10.5, 10.6, 10.7], [10, 10.1, 10.2, 10.22, 10.25]))

    def test_processes_that_overlap_decide_nothing(self):
        self.assertFalse(self.contest([10.3, 10.4, 10.5, 10.6, 10.7], [10, 10.1, 10.2, 10.31, 10.55]))


if __name__ == "__main__":
    unittest.main()
