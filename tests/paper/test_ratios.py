# SPDX-License-Identifier: MIT
"""What two times are said to show, in records of contests and in those from before. Needs no matplotlib and no LaTeX."""
import pathlib
import statistics
import sys
import types
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from changed_records import numbers, recorded  # noqa: E402  (the path must be set first)
from paper.numbers import contests, derived, ratios  # noqa: E402
from paper.records import Missing, Record  # noqa: E402
from paper.spread import median_interval, plain_mean  # noqa: E402


def record(samples, **parameters):
    low, high = median_interval(samples)
    parameters = {"samples_ms": samples, **parameters}
    return Record(parameters, statistics.median(samples), low, high, "machine:1")


def times(cuda, factors, **parameters):
    """OpenGL's and CUDA's record of one process, whose ratios by rounds are these."""
    return (record([time * factor for time, factor in zip(cuda, factors)], backend="opengl", **parameters),
            record(cuda, backend="cuda", **parameters))


class Ratios(unittest.TestCase):
    # The load doubles both times in some rounds, so that the intervals of the medians overlap.
    CUDA = [1, 2, 1, 2, 1, 2, 1, 2, 1, 2, 1]
    FACTORS = [1.09, 1.11, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.1, 1.09, 1.11]

    def test_turns_of_a_contest_are_compared_round_by_round(self):
        alone, contest = times(self.CUDA, self.FACTORS), times(self.CUDA, self.FACTORS, contest="collide_tiled 128")
        self.assertFalse(ratios.time_ratio(*alone).decided)
        self.assertRegex(ratios.time_ratio(*alone).text, r"^undecided \[0\..*, 1\..*\]‡$")
        self.assertTrue(ratios.time_ratio(*contest).decided)
        self.assertEqual("1.10x [1.10, 1.10]‡", ratios.time_ratio(*contest).text)
        for value, expected in zip(derived.ratio(*contest), (1.1, 0.0043, 0.0043)):
            self.assertAlmostEqual(expected, value, places=3)

    def test_a_family_decides_less_than_each_alone(self):
        weak = times([1.0] * 11, [1.0, 1.0, 1.0, 1.0, 1.0, 1.01, 1.01, 1.0, 1.01, 1.01, 1.0], contest="weak")
        self.assertTrue(0.02 < ratios.time_ratio(*weak).p < 0.05)
        self.assertEqual([True], [each.decided for each in ratios.family([weak])])
        self.assertEqual([False, False, False], [each.decided for each in ratios.family([weak] * 3)])
        self.assertEqual(["-", "undecided [1.00, 1.01]‡", "undecided [1.00, 1.01]‡", "undecided [1.00, 1.01]‡"], ratios.texts([None, weak, weak, weak]))

    def test_times_that_are_alike_are_undecided(self):
        same = times([1.0] * 11, [1.0] * 11, contest="same")
        self.assertEqual(1.0, ratios.time_ratio(*same).p)
        self.assertFalse(ratios.time_ratio(*same).decided)

    def test_a_marked_time_decides_nothing(self):
        glsl, cuda = times(self.CUDA, self.FACTORS, contest="collide_tiled 128")
        cuda.parameters["unsteady"] = ["other programs kept 80 % of this machine's cores busy"]
        for pair in (glsl, cuda), (cuda, glsl):
            self.assertFalse(ratios.time_ratio(*pair).decided)

    def test_one_value_of_each_decides_nothing(self):
        found = ratios.time_ratio(*times([1.0], [9.0]))
        self.assertEqual((9, False), (found.middle, found.decided))

    def test_what_a_comparison_stands_on(self):
        found = [ratios.Ratio(1, 1, 1, 1, processes, frozenset(gpus)) for processes, gpus in ((5, "AB"), (3, "A"))]
        self.assertEqual("three to five processes on one to two GPUs", ratios.extent(found))
        self.assertEqual("one process on one GPU", ratios.extent([ratios.Ratio(1, 1, 1, 1, 1)]))


class Stages(unittest.TestCase):
    def test_a_stage_at_the_timers_floor_is_no_comparison(self):
        stages = {"device_stages_ms": {"clear": 4e-3}, "device_stages_interval_ms": {"clear": [4e-3, 5e-3]}, "n": 64}
        glsl, cuda = (record([1.0], **stages) for _ in range(2))
        self.assertIsNotNone(derived.stage_ratio("clear", glsl, cuda))
        marked = record([1.0], device_stages_at_floor=["clear"], **stages)
        self.assertIsNone(derived.stage_ratio("clear", glsl, marked))


class Bases(unittest.TestCase):
    """What shares and ratios of the prose stand on."""

    def test_every_share_of_the_copy_rate_has_one_base(self):
        machine = recorded()
        rate = derived.copy_rate(machine)
        grid = machine.one(table="grid", scene="uniform", packing_fraction=0.3, method="collide_grid", order="cold",
                           backend="cuda", n=10**8)
        self.assertGreater(rate, grid.peak_per_second)
        self.assertAlmostEqual(100 * 91 * 10**8 / rate / (1e-3 * grid.median), derived.grid_share_of_floor(machine, grid))
        self.assertEqual(f"{derived.grid_share_of_floor(machine, grid):.0f}", numbers().entries["grid/floor/cuda/cold"][0])

    def test_a_kernel_counts_from_ten_times_an_empty_ones_reading(self):
        machine = recorded()
        least, compared = 10 * derived.timer_floor(machine), {row.kernel for row in derived.stage_ratios(machine)}
        self.assertGreater(least, 0.04)
        self.assertTrue(all(row.cuda_ms >= least and row.cuda_ms * row.ratio[0] >= least for row in derived.stage_ratios(machine)))
        self.assertEqual(set(), compared & {"clear", "grid_clear", "grid_sums", "resolve_undecided", "tally"})
        for k, record in enumerate(machine.records):
            if record.table == "overhead":  # had empty kernels read a hundred times that
                longer = {name: 100 * time for name, time in record.parameters.get("device_stages_ms", {}).items()}
                machine.records[k] = replace(record, parameters={**record.parameters, "device_stages_ms": longer})
        self.assertLess({row.kernel for row in derived.stage_ratios(machine)}, compared)

    def test_kernels_alone_are_of_the_program_and_variants_count_once(self):
        machine = recorded()
        timed = {row.kernel for row in derived.stage_ratios(machine)}
        rows = derived.kernels_alone(machine)
        names = [row.kernel for row in rows]
        self.assertLessEqual({"draw_cull", "draw_cull_far", "draw_cull_near", "peak_copy"}, timed)
        self.assertEqual(1, sum(name.startswith("draw_cull") for name in names))
        self.assertEqual([], [name for name in names if name.startswith("peak_")])
        self.assertLessEqual({"move", "collide_grid", "collide_triangle", "grid_split"}, set(names))
        self.assertEqual(sorted((row.ratio[0] for row in rows), reverse=True), [row.ratio[0] for row in rows])
        self.assertEqual("draw_cull", derived.source_kernel("draw_cull_near"))
        self.assertEqual("draw_tiles", derived.source_kernel("draw_tiles_rest"))
        self.assertEqual("collide_grid", derived.source_kernel("collide_grid"))

    def test_the_numbers_of_kernels_alone_are_those_of_the_rows(self):
        machine = recorded()
        values = [row.ratio[0] for row in derived.kernels_alone(machine)]
        text_of = {key: text for key, (text, *_) in numbers().entries.items()}
        self.assertEqual(str(len(values)), text_of["kernels/all"])
        self.assertEqual(f"{statistics.median(values):.2f}", text_of["kernels/median"])
        self.assertEqual(str(sum(0.96 <= value <= 1.04 for value in values)), text_of["kernels/close"])
        self.assertEqual([f"{value:.2f}x" for value in values[:2]], [text_of["kernels/worst"], text_of["kernels/second"]])
        self.assertEqual(len(values) - 1, text_of["kernels/list"].count(", "))

    def test_no_lead_of_an_api_is_a_percentage(self):
        for name, (text, *_) in numbers().entries.items():
            if name.split("/")[0] in ("lead", "methods", "contests") or name.startswith(("grid/lead", "grid/last", "draw/behind")):
                self.assertNotIn("\\%", text, name)


class Contests(unittest.TestCase):
    """The recorded contests by kind of work, from made-up records."""

    @staticmethod
    def machine(timings):
        """timings: table, ratio, parameters; each of its own size, in five processes whose ratios differ by `spread`."""
        records = []
        for n, (table, ratio, parameters) in enumerate(timings, 64):
            spread = parameters.get("spread", 0.01)
            for backend, factor in (("cuda", 1), ("opengl", ratio)):
                medians = [factor * (1 + (backend == "opengl") * spread * step) for step in (-1, -0.5, 0, 0.5, 1)][:parameters.get("runs", 5)]
                processes = [{"process": k, "gpu": "A", "median_ms": median, "plain_ms": (1 if backend == "cuda" else parameters.get("plain", 1)) * median,
                              "rounds": 2} for k, median in enumerate(medians)]
                samples = [value for median in medians for value in (0.999 * median, 1.001 * median)]
                records.append(Record({"table": table, "n": n, "backend": backend, "batch": 100, "scene": {"name": "random"}, "contest": str(n),
                                       "processes": processes, "samples_ms": samples, **parameters, **parameters.get(backend, {})},
                                      statistics.median(medians), min(medians), max(medians), "machine:1"))
        select = lambda table: [each for each in records if each.table == table]
        return types.SimpleNamespace(name="machine", select=select)

    def test_each_is_of_its_kind_of_work(self):
        found = contests.contests(self.machine([
            ("step", 1.7, {"work": "step"}), ("grid", 1.1, {"method": "collide_grid", "opengl": {"block": 64}}),
            ("table1", 0.8, {"work": "move"}), ("draw", 1.3, {"draw": "compute", "opengl": {"batch": 7, "contest": "other"}}),
            ("gas_steps", 1.2, {}), ("crossover", 2, {"way": "dense", "kind": "radii"}), ("crossover", 0.4, {"way": "collide_triangle", "kind": "one_cell"}),
            ("draw", 0.3, {"draw": "points"}), ("overhead", 3, {}), ("methods", 2, {"opengl": {"block": 64}})]))
        self.assertEqual([("all pairs", 1.7), ("all pairs", 0.4), ("grid", 1.1), ("grid", 2), ("motion", 0.8), ("drawing", 1.3), ("contacts", 1.2)],
                         [(entry.work, round(entry.ratio.middle, 9)) for entry in found])
        self.assertEqual(["drawing"], [entry.work for entry in found if not entry.same_steps])
        least, most = contests.extremes(found)
        self.assertEqual(("triangle, all spheres in one cell", "dense, unequal radii"), (least.what, most.what))

    def test_a_kind_is_one_family(self):
        weak = [("step", 1.012, {"spread": 0.01}), ("grid", 1.012, {"spread": 0.01, "method": "collide_grid"})]
        alone, among = (contests.contests(self.machine(weak + [("step", 1, {"spread": 0.3})] * more)) for more in (0, 20))
        self.assertEqual([True, True], [entry.ratio.decided for entry in alone])
        self.assertEqual([False, True], [entry.ratio.decided for entry in among if entry.ratio.middle > 1.01])

    def test_a_contest_of_one_process_says_nothing_of_several(self):
        found = contests.contests(self.machine([("step", 2, {}), ("step", 3, {"runs": 1})]))
        self.assertEqual([2], [round(entry.ratio.middle, 9) for entry in contests.several(found)])
        self.assertEqual("2.00x", contests.ratio_span(contests.short_steps(self.machine([("step", 2, {}), ("step", 3, {"runs": 1})]))))
        self.assertEqual(2, contests.extremes(found)[1].ratio.middle)
        with self.assertRaises(Missing):
            contests.extremes(contests.contests(self.machine([("step", 3, {"runs": 1})])))

    def test_plain_means_that_turn_a_sign_are_counted(self):
        found = contests.plain_means(contests.contests(self.machine([
            ("step", 1.1, {"plain": 0.8}), ("step", 1.1, {"plain": 1.02}), ("step", 1, {"plain": 1, "spread": 0.3})])))
        self.assertEqual((3, 1, 1), (found.contests, found.flips, found.decided_flips))
        self.assertAlmostEqual(2, found.percent)
        self.assertAlmostEqual(20, found.widest)

    def test_a_plain_mean_is_that_of_the_longest_batches(self):
        self.assertEqual(2.5, plain_mean({"batches": [1, 2, 4], "batch_ms": [[9, 9, 8], [9, 9, 12]]}))
        self.assertIsNone(plain_mean({"samples_ms": [1]}))


if __name__ == "__main__":
    unittest.main()
