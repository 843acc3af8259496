# SPDX-License-Identifier: MIT
"""Records of several processes become one: median of the medians, t-interval of their logarithms. What was recorded in
pieces is read as a whole."""
import json
import math
import pathlib
import statistics
import sys
import tempfile
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper import spread  # noqa: E402
from paper.numbers import layers, prose_equality, ratios  # noqa: E402
from paper.records import Machine, Missing, Record  # noqa: E402


def timing(middle, within=0.01, **parameters):
    samples = [middle * (1 - within), middle, middle * (1 + within)]
    return {"table": "grid", "backend": "cuda", "label": "cuda collide_grid", "n": 1024, "batch": int(1e3 / middle),
            "scene": {"name": "uniform", "packing_fraction": 0.3}, "samples_ms": samples, "median_ms": middle,
            "interval_ms": [samples[0], samples[2]], "device_stages_ms": {"collide_grid": middle},
            "device_stages_interval_ms": {"collide_grid": [samples[0], samples[2]]}, **parameters}


def record(*rows, gpu="A", **more):
    return {"context": {"date": "2026", "sources": {"measure": gpu}}, "measurements": list(rows),
            "backends": [{"name": "cuda", "open": True, "device": "H200", "uuid": gpu}], **more}


class Merged(unittest.TestCase):
    def merged(self, middles, gpus="AAAAA", within=0.01):
        roots = [record(timing(middle, within), gpu=gpu) for middle, gpu in zip(middles, gpus)]
        return spread.merged(roots)["measurements"][0]

    def test_a_time_is_the_median_with_a_t_interval_of_the_logarithms(self):
        row = self.merged([10, 8, 12.5, 11, 10])
        self.assertEqual(10, row["median_ms"])
        middle, half = 10.1925, 0.2029  # mean of the logarithms, and 2.776 standard errors of it
        for expected, end in zip((middle * math.exp(-half), middle * math.exp(half)), row["interval_ms"]):
            self.assertAlmostEqual(expected, end, delta=0.02)

    def test_the_spread_within_a_process_does_not_widen_it(self):
        self.assertEqual(self.merged([10, 8, 12], within=0.5)["interval_ms"], self.merged([10, 8, 12])["interval_ms"])

    def test_of_one_process_it_is_that_of_its_rounds(self):
        self.assertEqual([9.9, 10.1], self.merged([10])["interval_ms"])

    def test_variation_is_within_processes_between_them_and_between_gpus(self):
        row = self.merged([10, 10.2, 10, 13, 13.1], gpus="AAABB")
        found = layers.layers(Record(row, *spread.summary(row), "made up"))
        self.assertAlmostEqual(2, found["within"])
        self.assertAlmostEqual(100 * 0.2 / 10.2, found["processes"])
        self.assertAlmostEqual(100 * 3.05 / 10.2, found["gpus"])
        self.assertEqual({"within", "gpus"}, set(layers.layers(Record(self.merged([10, 11], gpus="AB"), 10, 10, 10, "made up"))))

    def test_equal_times_have_an_interval_of_no_width(self):
        self.assertEqual([0.0384, 0.0384], self.merged([0.0384] * 3)["interval_ms"])

    def test_all_samples_and_stages_are_kept(self):
        row = self.merged([10, 12])
        self.assertEqual(6, len(row["samples_ms"]))
        self.assertAlmostEqual(12 + 0.75 * 0.12, row["p95_ms"])
        self.assertEqual([10, 12], [run["median_ms"] for run in row["processes"]])
        low, high = row["device_stages_interval_ms"]["collide_grid"]
        self.assertTrue(low < 9 and high > 13)  # the t-interval of two processes
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
        self.assertNotIn("processes", Machine(self.folder).one(table="step").parameters)

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
        self.assertLess(1000, len(recorded().records))


class Batches(unittest.TestCase):
    """What the study says of its method: K is so large that a batch's fixed cost is below 0.5 % in the median."""

    def test_what_a_batch_costs_besides_its_steps_is_under_half_a_percent(self):
        machine = recorded()
        for part in ("results.json", "sweep", "launches.json", "ablate.json", "frame_rates.json", "precision_float32.json"):
            of_part = [record for record in machine.records if record.source == machine.source(part)["id"]]
            for api in ("opengl", "cuda"):
                shares = [100 * abs(record.fixed_cost_share) for record in of_part
                          if record.backend == api and record.parameters.get("fixed_cost_share") is not None]
                self.assertGreater(len(shares), 25, f"{part} {api}")
                self.assertLess(statistics.median(shares), prose_equality.AIM, f"{part} {api}")


class Ratios(unittest.TestCase):
    """Of the turns of several processes: an interval that pools their rounds would be too narrow."""

    @staticmethod
    def pair(rows_of_each):
        roots = [record(*rows) for rows in rows_of_each]
        return [Record({**row, "contest": "made up"}, *spread.summary(row), "made up")
                for row in spread.merged(roots)["measurements"]]

    def ratio(self, factors):
        return ratios.time_ratio(*self.pair([(timing(10 * factor, backend="opengl"), timing(10)) for factor in factors]))

    def test_processes_that_contradict_each_other_decide_nothing(self):
        found = self.ratio([1.2, 1.3, 1.4, 1.1, 0.85])
        self.assertAlmostEqual(1.2, found.middle)
        self.assertTrue(found.low < 1 < found.high)
        self.assertFalse(found.decided)

    def test_a_lead_in_every_process_is_one(self):
        found = self.ratio([1.2, 1.3, 1.4, 1.1, 1.15])
        self.assertAlmostEqual(1.2, found.middle)
        self.assertTrue(1 < found.low and found.decided)
        self.assertEqual((5, 1), (found.processes, len(found.gpus)))

    def test_a_process_that_lacks_one_of_them_does_not_count(self):
        both = (timing(12, backend="opengl"), timing(10))
        found = ratios.time_ratio(*self.pair([both, (timing(30, backend="opengl"),), both]))
        self.assertEqual(2, found.processes)
        self.assertAlmostEqual(1.2, found.middle)
        alone = ratios.time_ratio(*self.pair([(timing(30, backend="opengl"),), both]))
        self.assertEqual(1, alone.processes)
        self.assertAlmostEqual(1.2, alone.middle)

    def test_processes_decide_times_that_took_no_turns(self):
        for cuda, decided in (([10, 10.1, 10.2, 10.22, 10.25], True), ([10, 11.1, 10.2, 10.9, 10.55], False)):
            glsl, other = self.pair([(timing(left, backend="opengl"), timing(right)) for left, right in zip([10.3, 10.4, 10.5, 10.6, 10.7], cuda)])
            other.parameters["contest"] = "another"
            self.assertEqual(decided, ratios.time_ratio(glsl, other).decided)

    def test_records_of_other_runs_are_independent(self):
        glsl, cuda = self.pair([(timing(12, backend="opengl"), timing(10 + k)) for k in (0, 0.1, 0.2)])
        found = ratios.time_ratio(glsl, replace(cuda, source="another"))
        self.assertAlmostEqual(12 / 10.1, found.middle)
        self.assertTrue(found.decided)


if __name__ == "__main__":
    unittest.main()
