# SPDX-License-Identifier: MIT
"""What two times are said to show, in records of contests and in those from before. Needs no matplotlib and no LaTeX."""
import pathlib
import statistics
import sys
import types
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper.numbers import contests, derived, macros, ranks  # noqa: E402  (the path must be set first)
from paper.records import DATA, MAIN, Machine, Record, median_interval  # noqa: E402


class Ranks(unittest.TestCase):
    def test_apart_and_alike(self):
        low, high = list(range(11)), list(range(20, 31))
        self.assertAlmostEqual(2 / 705432, ranks.rank_test(low, high))
        self.assertEqual(1.0, ranks.rank_test(low, low))
        self.assertAlmostEqual(0.2, ranks.rank_test([1, 2, 4], [3, 5, 6]))

    @staticmethod
    def record(samples, **parameters):
        low, high = median_interval(samples)
        parameters = {"samples_ms": samples, **parameters}
        return Record(parameters, statistics.median(samples), low, high, "machine:1")

    # The load doubles both times in some rounds, so that the intervals of the medians overlap.
    def test_turns_of_a_contest_are_compared_round_by_round(self):
        cuda = [1, 2, 1, 2, 1, 2, 1, 2, 1, 2, 1]
        glsl = [1.1 * time for time in cuda]
        alone = [self.record(samples) for samples in (glsl, cuda)]
        contest = [self.record(samples, contest="collide_tiled 128") for samples in (glsl, cuda)]
        self.assertEqual("no difference seen", ranks.ratio_text(*alone))
        self.assertEqual("1.10x [1.10, 1.10]", ranks.ratio_text(*contest))
        self.assertTrue(ranks.apart(*contest))
        for value, expected in zip(derived.ratio(*contest), (1.1, 0, 0)):
            self.assertAlmostEqual(expected, value)
        other = self.record(cuda, contest="collide_square 128")
        self.assertFalse(ranks.apart(contest[0], other))

    def test_a_marked_time_decides_nothing(self):
        cuda = [1.0] * 11
        glsl = self.record([1.5 * time for time in cuda], contest="collide_tiled 128")
        calm, busy = (self.record(cuda, contest="collide_tiled 128", **mark)
                      for mark in ({}, {"unsteady": ["other programs kept 80 % of this machine's cores busy"]}))
        self.assertTrue(ranks.differ(glsl, calm) and ranks.apart(glsl, calm))
        for pair in (glsl, busy), (busy, glsl):
            self.assertFalse(ranks.differ(*pair) or ranks.apart(*pair))
        self.assertEqual("no difference seen", ranks.ratio_text(glsl, busy))

    def test_a_stage_at_the_timers_floor_is_no_comparison(self):
        stages = {"device_stages_ms": {"clear": 4e-3}, "device_stages_interval_ms": {"clear": [4e-3, 5e-3]}, "n": 64}
        glsl, cuda = (self.record([1.0], **stages) for _ in range(2))
        self.assertIsNotNone(derived.stage_ratio("clear", glsl, cuda))
        marked = self.record([1.0], device_stages_at_floor=["clear"], **stages)
        self.assertIsNone(derived.stage_ratio("clear", glsl, marked))


class Bases(unittest.TestCase):
    """What shares and ratios of the prose stand on."""

    def test_every_share_of_the_copy_rate_has_one_base(self):
        machine = Machine(DATA / MAIN)
        rate = derived.copy_rate(machine)
        grid = machine.one(table="grid", scene="uniform", packing_fraction=0.3, method="collide_grid", order="cold",
                           backend="cuda", n=10**8)
        self.assertGreater(rate, grid.peak_per_second)
        self.assertAlmostEqual(100 * 91 * 10**8 / rate / (1e-3 * grid.median), derived.grid_share_of_floor(machine, grid))
        numbers = macros.collect(machine, []).entries
        self.assertEqual(f"{derived.grid_share_of_floor(machine, grid):.0f}", numbers["grid/floor/cuda/cold"][0])

    def test_a_kernel_that_reads_as_an_empty_one_is_no_comparison(self):
        machine = Machine(DATA / MAIN)
        compared = {row.kernel for row in derived.stage_ratios(machine)}
        self.assertEqual(set(), compared & {"clear", "grid_clear", "grid_sums", "resolve_undecided"})
        for k, record in enumerate(machine.records):
            if record.table == "overhead":  # had empty kernels read a hundred times that
                longer = {name: 100 * time for name, time in record.parameters.get("device_stages_ms", {}).items()}
                machine.records[k] = replace(record, parameters={**record.parameters, "device_stages_ms": longer})
        self.assertLess({row.kernel for row in derived.stage_ratios(machine)}, compared)

    def test_no_lead_of_an_api_is_a_percentage(self):
        for name, (text, *_) in macros.collect(Machine(DATA / MAIN), []).entries.items():
            if name.split("/")[0] in ("lead", "methods", "ratio") or name.startswith(("grid/lead", "grid/last", "draw/behind")):
                self.assertNotIn("\\%", text, name)


class Contests(unittest.TestCase):
    """The recorded contests by the duration of CUDA's step, from made-up records."""

    @staticmethod
    def machine(timings):
        """timings: table, CUDA's microseconds, ratio, parameters, of which width is that of the times' intervals; each of
        its own size."""
        records = []
        for n, (table, cuda_us, ratio, parameters) in enumerate(timings, 64):
            for backend, factor in (("cuda", 1), ("glsl", ratio)):
                time, width = 1e-3 * cuda_us * factor, parameters.get("width", 1)
                records.append(Record({"table": table, "n": n, "backend": backend, "batch": 100, "scene": {"name": "random"},
                                       **parameters, **parameters.get(backend, {})}, time, time / width, time * width,
                                      "machine:1"))
        select = lambda table: [record for record in records if record.table == table]
        return types.SimpleNamespace(name="machine", select=select)

    def test_each_is_in_the_bin_of_cudas_step_and_of_its_work(self):
        found = contests.contests(self.machine([
            ("step", 5, 1.7, {"work": "step"}), ("grid", 40, 1.1, {"method": "collide_grid", "glsl": {"block": 64}}),
            ("table1", 6, 0.8, {"work": "move"}), ("draw", 2000, 1, {"draw": "compute", "glsl": {"batch": 7}}),
            ("draw", 500, 0.3, {"draw": "points"}), ("overhead", 5, 3, {}), ("methods", 9, 2, {"glsl": {"block": 64}})]))
        self.assertEqual([("all pairs", 5, 1.7), ("motion", 6, 0.8), ("grid", 40, 1.1), ("drawing", 2000, 1)],
                         [(entry.work, round(entry.cuda_us, 9), round(entry.ratio, 9)) for entry in found])
        self.assertEqual([True, True, True, False], [entry.same_steps for entry in found])
        self.assertEqual([(0, 1.25), (30, 1.1), (1000, 1)],
                         [(each.low, round(each.median, 9)) for each in contests.bins(found)])

    def test_the_rule_states_the_duration_from_which_ratios_are_small(self):
        steps = [("step", 5, 1.7, {}), ("step", 8, 1.3, {}), ("step", 50, 1.1, {}), ("step", 200, 1, {})]
        self.assertRegex(contests.rule(self.machine(steps)), "below 30 µs GLSL takes 1.30x to 1.70x CUDA's time, above it "
                                                            "1.00x to 1.10x")

    def test_the_rule_says_who_leads_where_a_short_step_takes_less_time_in_glsl(self):
        pairs = [("step", us, 1.7, {}) for us in (5, 6, 6)] + [("step", 50, 1.1, {})]
        for widths, led in (((1, 1), "GLSL leads in 2 of 2"), ((1.5, 1), "GLSL leads in 1 of 2"),
                            ((1.5, 1.5), "neither leads in 2")):
            moves = [("table1", 5, ratio, {"work": "move", "width": width}) for ratio, width in zip((0.7, 0.8), widths)]
            self.assertRegex(contests.rule(self.machine(pairs + moves)),
                             rf"CUDA's time \({led} contests of motion, one launch a step: 0.70x to 0.80x\), above")
        self.assertRegex(contests.rule(self.machine(pairs + [("table1", 5, 0.9, {})])),
                         r"\(GLSL leads in 1 of 1 contest of all pairs: 0.90x\)")

    def test_no_rule_where_no_duration_separates_the_ratios(self):
        self.assertRegex(contests.rule(self.machine([("step", 5, 1, {}), ("step", 50, 1.5, {})])), "does not separate")


if __name__ == "__main__":
    unittest.main()
