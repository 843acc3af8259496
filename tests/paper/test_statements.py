# SPDX-License-Identifier: MIT
"""Statements of the paper that its records once contradicted: each is made from the records, or the paper is refused."""
import contextlib
import importlib.util
import io
import pathlib
import re
import sys
import unittest
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
if importlib.util.find_spec("matplotlib") is None:
    print("SKIPPED: figures need matplotlib (python3-matplotlib)")
    sys.exit(77)

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper.numbers import macros, prose_accuracy, prose_compared, prose_limits, prose_measured, stress  # noqa: E402
from paper.numbers.derived import cost, pairs_of  # noqa: E402
from paper.plots import floor, grid  # noqa: E402
from paper.records import Missing  # noqa: E402
from paper.tables.counters import counters  # noqa: E402

TEX = re.sub(r"\s+", " ", (ROOT / "paper/paper.tex").read_text())


class Statements(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.machine = recorded()

    def made(self, make, machine=None):
        found = {}
        make(lambda key, text, *_: found.update({key: text}), machine or self.machine, [])
        return found

    def altered(self, wanted, **parameters):
        """The machine with other parameters, or other medians, of some records."""
        machine = recorded()
        times = parameters.pop("times", 1)
        machine.records = [replace(row, median=times * row.median, low=times * row.low, high=times * row.high, parameters={
            **row.parameters, **parameters, "samples_ms": [times * sample for sample in row.samples_ms]})
            if row.matches(wanted) else row for row in machine.records]
        return machine

    def refused(self, make, machine):
        with self.assertRaisesRegex(Missing, "the text says"):
            self.made(make, machine)


class Exactness(Statements):
    def test_the_bound_is_that_of_every_method_of_a_gpu(self):
        highs = [cost(naive, exact)[2] for exact, naive in pairs_of(self.machine) if exact.backend != "cpu"]
        self.assertEqual(f"{max(highs):.1f}", self.made(prose_measured.exactness)["exact/bound"])

    def test_a_cost_through_the_grid_refuses(self):
        wanted = {"table": "exactness", "method": "collide_grid", "backend": "cuda", "exact": True}
        self.refused(prose_measured.exactness, self.altered(wanted, times=1.5))

    def test_wide_intervals_of_the_cpu_decide_nothing(self):
        text = self.made(prose_measured.exactness)["exact/cpu"]
        self.assertRegex(text, r"^its cost is undecided: the intervals reach from \$-\d+\$ to \$\+\d+\$|^it costs \d")

    def test_far_from_the_origin_it_has_a_cost(self):
        low, high = map(int, self.made(prose_limits.exactness_far_away)["naive/far/cost"].split(" to "))
        times = [float(self.made(prose_accuracy.naive_sets)[f"naive/far/times/{name}"]) for name in ("opengl", "cuda")]
        self.assertEqual([low, high], sorted(round(100 * (value - 1)) for value in times))


class Limits(Statements):
    def counted(self, kernel, **changed):
        """The machine with other hardware counters of a kernel."""
        machine = recorded()
        source = machine.source("counters.json")
        machine.sources["counters.json"] = {**source, "counters": [row | (changed if row["kernel"] == kernel else {}) for row in source["counters"]]}
        return machine

    def test_a_search_bound_by_memory_refuses(self):
        self.refused(prose_limits.limits_of_the_grid, self.counted("collide_grid", dram_percent=95))

    def test_a_sort_bound_by_instructions_refuses(self):
        self.refused(prose_limits.limits_of_the_grid, self.counted("grid_sort", nearest_limit="smsp__issue_active"))

    def test_the_table_has_every_profiled_kernel(self):
        rows = counters(self.machine).rows
        self.assertEqual(len(self.machine.source("counters.json")["counters"]), len(rows))
        search = next(row for row in rows if row[:3] == ["collide_grid", "10,000,000", "cell"])
        found = self.made(prose_limits.limits_of_the_grid)
        self.assertEqual([found["limit/search/issue"], found["limit/search/loads"], found["limit/search/memory"]], [search[4], search[5], search[7]])


class TensorCores(Statements):
    def test_they_are_named_where_they_win(self):
        self.assertGreater(float(self.made(prose_limits.tensor_cores)["tensor/over-glsl"][:-1]), 1)

    def test_slow_ones_refuse(self):
        self.refused(prose_limits.tensor_cores, self.altered({"table": "tensor", "method": "collide_tensor"}, times=99))

    def test_their_run_is_no_part_of_the_sweeps_lines(self):
        """CUDA's points would be of another GPU and process than its line, and GLSL would have none."""
        names = {self.machine.source("sweep_tensor")["id"]}
        lines = [rows for name in ("opengl", "cuda") for _, _, rows in grid.sets(self.machine, name, 0.3)]
        lines += [floor.with_floor(self.machine, backend="cuda", method="collide_triangle")]
        for rows in lines:
            self.assertFalse(names & {row.source for row in rows})
        both = [[row.n for label, _, rows in grid.sets(self.machine, name, 0.3) if label == "all pairs" for row in rows] for name in ("opengl", "cuda")]
        self.assertEqual(*both)

    def test_the_fastest_method_is_said_to_be_that_of_both_apis(self):
        for match in re.finditer(r"fastest method", TEX):
            self.assertRegex(TEX[match.start():match.start() + 60], "^fastest method(?: that both APIs can express|'' in this paper)")


class Others(Statements):
    def test_the_peers_wrong_pairs_are_of_a_count_that_both_apis_found(self):
        wanted = {"table": "grid", "backend": "opengl", "order": "cold", "n": 10**8}
        self.refused(prose_compared.against_peers, self.altered(wanted, pairs=1))

    def test_a_record_of_the_catalogue_names_its_own_machine_or_none(self):
        context = {"machine": {"cpu": "Abacus(R)", "hardware_threads": 3}, "build": {"commit": "c0ffee" * 7}}
        for contexts, text in (([None, None], "whose host and commit the record does not name"),
                               ([context, context], "Abacus with 3 hardware threads, commit c0ffeec0ffee")):
            self.machine.source("stress.json")["contexts"] = contexts
            self.assertEqual(text, self.made(prose_accuracy.catalogue)["stress/where"])
        self.assertEqual([], stress.places(types_of([None])))

    def test_a_given_number_without_a_source_is_found(self):
        frame = "\\begin{abstract}%s\\begin{thebibliography}"
        macros.check(frame % "a GTX~\\given{590}", macros.Numbers())
        with contextlib.redirect_stderr(io.StringIO()) as told, self.assertRaises(Missing):
            macros.check(frame % "from \\given{1.25}x", macros.Numbers())
        self.assertIn("\\given{1.25}", told.getvalue())

    def test_constants_of_the_sources_are_those_of_the_text(self):
        for file, pattern, text in (
                ("glsl/device_limits.cpp", r"large_page = (\d+) << 20;", r"OpenGL's buffers of \given{%s}\,MiB and more are not plain OpenGL storage"),
                ("shaders/collide/collide_grid.comp", r"UNDECIDED_ROOM = (\d+)u;", r"each group keeps its first \given{%s} undecided pairs")):
            self.assertIn(text % re.search(pattern, (ROOT / file).read_text())[1], TEX)

    def test_each_listed_number_is_used(self):
        self.assertEqual(set(macros.GIVEN), set(re.findall(r"\\given\{([^}]*)\}", TEX)) - {"#1"})


def types_of(contexts):
    class Made:
        @staticmethod
        def source(name):
            return {"contexts": contexts}
    return Made


if __name__ == "__main__":
    unittest.main()
