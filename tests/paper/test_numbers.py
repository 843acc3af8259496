# SPDX-License-Identifier: MIT
"""The paper's numbers come from recorded runs, and the checks of that can fail. Needs no matplotlib and no LaTeX."""
import contextlib
import copy
import io
import json
import pathlib
import sys
import tempfile
import unittest
from dataclasses import replace

PAPER = pathlib.Path(__file__).resolve().parents[2] / "paper"
sys.path.insert(0, str(PAPER.parent))

from changed_records import all_pairs, changed, numbers, recorded  # noqa: E402
from paper import formats  # noqa: E402  (the path must be set first)
from paper.numbers import leads, macros, prose_contacts  # noqa: E402
from paper.records import DATA, MAIN, Machine, Missing  # noqa: E402
from paper.spread import median_interval, p95  # noqa: E402
from paper.tables import stress as stress_table  # noqa: E402
from paper.tables import tabular  # noqa: E402

FRAME = "\\begin{abstract}%s\\begin{thebibliography}"


def check(prose, numbers, recorded=()):
    with contextlib.redirect_stderr(io.StringIO()):
        macros.check(FRAME % prose, numbers, recorded)


class Prose(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.numbers = numbers()

    def test_every_number_of_the_paper_is_recorded(self):
        macros.check((PAPER / "paper.tex").read_text(), self.numbers)

    def test_text_without_its_figure_needs_no_number(self):
        prose = "A. \\ifrecorded{abacus}{It takes \\Nr{step/abacus}\\,ms {at} 5.} B."
        check(prose, self.numbers)
        with self.assertRaises(Missing):
            check(prose, self.numbers, ["abacus"])

    def test_a_number_without_a_run_is_found(self):
        with self.assertRaises(Missing):
            check("It takes \\Nr{step/abacus}\\,ms.", self.numbers)

    def test_a_digit_in_the_prose_is_found(self):
        check("A step on an H100 takes \\Nr{step/opengl}\\,ms of $2^{20}$, see GTX~\\given{590}.", self.numbers)
        for prose in ("It takes 0.068\\,ms.", "GLSL is 8\\,\\% faster.", "In 2 of \\Nr{step/opengl} cases."):
            with self.assertRaises(Missing, msg=prose):
                check(prose, self.numbers)

    def test_a_number_names_the_file_it_comes_from(self):
        text, source, _ = self.numbers.entries["step/opengl"]
        self.assertEqual(recorded().id, source)
        self.assertEqual(f"{recorded().one(table='step', backend='opengl', n=16384).median:.4f}", text)


class WhoLeads(unittest.TestCase):
    """The statements of the prose about leads follow the records, or the paper is refused."""

    def sentences(self, factor):
        found = leads.contests(changed(all_pairs("opengl"), factor))
        return leads.headline(found), leads.wins(found), leads.at_large_sizes(found)

    def test_one_api_throughout(self):
        for factor, winner, ratio in ((10, "CUDA", r"\d+\.\d\dx"), (0.1, "OpenGL", r"0\.\d\dx")):
            head, wins, large = self.sentences(lambda _: factor)
            self.assertEqual(f"{winner} wins throughout", head)
            self.assertRegex(wins, rf"^OpenGL takes {ratio} to {ratio} CUDA's time at every size$")
            self.assertRegex(large, rf"^in 6 of 6 contests of 65,536 spheres and more {winner}'s compiler .*OpenGL takes {ratio}")

    def test_a_number_of_spheres_separates_them(self):
        head, wins, _ = self.sentences(lambda record: 10 if record.n < 4096 else 0.1)
        self.assertEqual("neither API wins throughout", head)
        self.assertRegex(wins, "^OpenGL takes 1\\d.* up to 2,048 spheres and 0\\..* from 4,096 on$")
        self.assertRegex(self.sentences(lambda record: 0.1 if record.n < 4096 else 10)[1],
                         "^OpenGL takes 0\\..* up to 2,048 spheres and [1-9].* on$")

    def test_no_order_of_sizes_is_stated_if_there_is_none(self):
        _, wins, large = self.sentences(lambda record: 0.1 if record.n in (1024, 65536) else 10)
        self.assertRegex(wins, "^of 22 contests, OpenGL takes [1-9].* CUDA's time in 17 and 0\\..* in 5$")
        self.assertRegex(large, "^in 4 of 6 .* CUDA's compiler .*, and OpenGL's in 2 ")

    def test_kinds_of_work_that_differ_are_separated(self):
        gas = {"table": "scale", "scene": "uniform"}
        _, wins, _ = self.sentences(lambda record: 0.1 if record.matches(gas) and record.n > 16384 else 10)
        self.assertRegex(wins, "^in all pairs of the original's box and in whole steps OpenGL takes [1-9].* at every "
                               "size; in all pairs of a gas OpenGL takes [1-9].* up to 16,384 spheres and 0\\..* from 65,536 on$")

    def test_alike_is_no_lead(self):
        machine = recorded()
        of_cuda = {(r.table, r.n, str(r.scene)): r for r in machine.records if all_pairs("cuda")(r)}
        alike = lambda r: of_cuda[r.table, r.n, str(r.scene)]
        machine.records = [replace(alike(r), parameters={**alike(r).parameters, "backend": "opengl"})
                           if all_pairs("opengl")(r) else r for r in machine.records]
        found = leads.contests(machine)
        self.assertEqual("no difference is decided", leads.headline(found))
        self.assertEqual("no difference is decided", leads.wins(found))

    def refused(self, wanted, factor, *makers):
        """Of these makers, or of all: those that refuse records so changed."""
        chosen = [make for make in macros.MAKERS if not makers or make.__name__ in makers]
        return [name for name, reason in macros.collect(changed(wanted, factor), [recorded("llvmpipe")], makers=chosen).left_out
                if "the text says" in reason]

    def test_prose_that_does_not_follow_refuses(self):
        for maker, wanted, factor in (
                ("who_leads", {"table": "scale", "backend": "opengl"}, 2),
                ("one_launch", {"table": "table1", "work": "move", "backend": "opengl"}, 2),
                ("exactness", {"table": "exactness", "method": "collide_tiled", "exact": True, "backend": "opengl"}, 1.02),
                ("launches", {"table": "overhead", "backend": "cuda"}, 2),
                ("arrangements", {"table": "methods", "method": "collide_tiled"}, 0.2),
                ("group_sizes", {"table": "methods", "method": "collide_square", "block": 128}, 2),
                ("whole_steps", {"table": "step", "backend": "cpu"}, 0.01),
                ("keeping_order", {"table": "grid", "backend": "cuda", "order": "warm"}, 3),
                ("grid_leads", {"table": "grid", "backend": "opengl"}, 0.5),
                ("against_peers", {"table": "grid", "backend": "cuda"}, 9),
                ("drawing", {"table": "draw", "backend": "opengl", "n": 10**8}, 999),
                ("transfers", {"table": "interop", "way": "through the host's memory"}, 1e-3),
                ("kinds_of_spheres", {"table": "crossover", "kind": "one_cell", "way": "dense"}, 1e-3),
                ("exactness", {"table": "exactness", "method": "collide_triangle", "exact": True}, 2),
                ("errors_of_motion", {"table": "precision", "method": "anchored"}, 99)):
            self.assertIn(maker, self.refused(lambda record: record.matches(wanted), lambda _: factor, maker), wanted)
        self.assertEqual([], self.refused(lambda record: False, None))

    def test_an_ablation_that_turns_refuses(self):
        for option in ("batch", "exact_stages", "own_buckets"):
            wanted = lambda record: record.table == "ablation" and record.option == option and record.on
            self.assertIn("ablations", self.refused(wanted, lambda _: 20, "ablations"))


class Contacts(unittest.TestCase):
    """What the prose says of contacts follows the records, or the paper is refused."""

    def refused(self, make, wanted, **altered):
        machine = recorded()
        make(lambda *_: None, machine, [])
        machine.records = [replace(row, parameters={**row.parameters, **altered}) if row.matches(wanted) else row
                           for row in machine.records]
        with self.assertRaisesRegex(Missing, "the text says"):
            make(lambda *_: None, machine, [])

    def test_bits_and_errors(self):
        run = {"table": "contact_runs", "backend": "opengl", "law": "hertz", "steps_a_contact": 40}
        self.refused(prose_contacts.contact_bits, {**run, "sums": "integers"}, momentum=[0, 1, 0])
        self.refused(prose_contacts.contact_bits, {**run, "sums": "integers"}, returns=False)
        self.refused(prose_contacts.contact_bits, {**run, "sums": "in_order"}, momentum=[0, 0, 0])
        self.refused(prose_contacts.contact_errors, {**run, "sums": "atomics"}, position=1e-5)

    def test_times(self):
        self.refused(prose_contacts.contact_times, {"table": "gas_steps", "backend": "cuda"}, sphere_steps_per_second=9e9)
        self.refused(prose_contacts.contact_times, {"table": "contact_sums", "sums": "integers", "n": 10**7}, samples_ms=[9] * 11)

    def test_rates(self):
        machine = recorded()
        root = machine.sources["contacts.json"] = copy.deepcopy(machine.sources["contacts.json"])
        root["contact_rates"][0]["error"]["median"] = 0.02
        with self.assertRaisesRegex(Missing, "the time step changes the pressure"):
            prose_contacts.contact_rates(lambda *_: None, machine, [])


class Stress(unittest.TestCase):
    """The catalogue's table, from made-up tests of every row."""

    @staticmethod
    def table(verdict="pass", rows=33):
        machine = recorded()
        found = [{"row": row, "scene": "a lattice", "what": "it holds", "backend": name, "figure": "0 wrong of 100000",
                  "bound": "1e-04 m", "verdict": verdict if row == 7 else "pass"}
                 for row in range(1, rows + 1) for name in ("cpu", "opengl", "cuda")]
        machine.sources["stress.json"] = {"rows": found, "id": "made up"}
        return stress_table.stress(machine)

    def test_a_row_a_test_and_a_verdict_a_backend(self):
        rows = self.table().rows
        self.assertEqual(33, len(rows))
        self.assertEqual(["7", "a lattice", "it holds", "0 wrong of 100,000", "1e-04 m", *["pass"] * 3], rows[6])

    def test_a_failed_and_an_absent_row_are_refused(self):
        for wrong in ({"verdict": "FAIL"}, {"rows": 32}):
            with self.assertRaises(Missing):
                self.table(**wrong)

    def test_backends_that_found_different_figures_are_named(self):
        self.assertEqual("CPU, OpenGL: 1 m; CUDA: 2 m",
                         stress_table.figure_text({"cpu": "1 m", "opengl": "1 m", "cuda": "2 m"}))

    def test_numbers_are_set_as_mathematics(self):
        self.assertEqual("0 wrong of 100000, $\\pm$ $10^{-4}$, $5.8\\cdot10^{-5}$ m, 0, $2^{-149}$, 4096",
                         tabular.typeset("0 wrong of 100000, +- 1e-04, 5.8e-05 m, 0.0e+00, 2^-149, 4096"))


class Records(unittest.TestCase):
    def test_none_or_several_are_refused(self):
        machine = recorded()
        for wanted in ({"table": "step", "backend": "abacus"}, {"table": "step", "backend": "opengl"}):
            with self.assertRaises(Missing):
                machine.one(**wanted)

    def test_intervals_and_percentiles_are_those_of_the_program(self):
        roots = [json.loads(path.read_text()) for path in (DATA / MAIN).rglob("*.json")]
        rows = [row for root in roots for row in formats.rows_of(root) if "interval_ms" in row]  # not those of energy
        self.assertLess(100, len(rows))
        for row in rows:
            self.assertEqual(row["interval_ms"], list(median_interval(row["samples_ms"])))
            self.assertAlmostEqual(row["p95_ms"], p95(row["samples_ms"]), delta=1e-9 * row["p95_ms"])

    def test_a_folder_without_results_is_refused(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(Missing):
            Machine(folder)


if __name__ == "__main__":
    unittest.main()
