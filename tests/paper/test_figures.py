# SPDX-License-Identifier: MIT
"""Every figure and table of the paper can be made from the recorded runs, and says what of them is stale."""
import contextlib
import importlib.util
import io
import json
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock
from dataclasses import replace

PAPER = pathlib.Path(__file__).resolve().parents[2] / "paper"
sys.path.insert(0, str(PAPER.parent))
if importlib.util.find_spec("matplotlib") is None:
    print("SKIPPED: figures need matplotlib (python3-matplotlib)")
    sys.exit(77)

from changed_records import laid_out_alone, recorded  # noqa: E402  (the path must be set first)
from paper import all_figures, figures, sources, style  # noqa: E402
from paper.page import contents  # noqa: E402
from paper.plots import ratio  # noqa: E402
from paper.records import Machine, Missing, Record, latest  # noqa: E402
from paper.tables import all_tables, energy, studies  # noqa: E402

SCENE = {"name": "uniform", "packing_fraction": 0.3}


def made_up_crossovers(cells, time_of_auto):
    square, grid = {"name": "collide_square", "block": 32}, {"name": "collide_grid", "cells": cells}
    return [record for n, times, taken in ((64, (1, 3, 3, 1), square), (1024, (9, 2, 4, time_of_auto), grid))
            for way, time in zip(("collide_square/32", "dense", "hashed", "auto"), times)
            for record in [Record({"table": "crossover", "kind": "gas", "way": way, "n": n, "backend": "opengl",
                                   "choice": taken, "scene": SCENE, "label": "made up", "contest": "made up",
                                   "samples_ms": [time * factor for factor in (0.99, 1, 1, 1, 1, 1, 1.01)]}, time, time, time,
                                  "made up")]]


class Figures(unittest.TestCase):
    def test_timings_lost_in_noise_are_no_records(self):
        one = {"n": 1, "backend": "cpu", "samples_ms": [2.0] * 6}
        rows = [{**one, "median_ms": median, "interval_ms": interval}
                for median, interval in ((2.0, [1, 3]), (2.0, [-0.1, 3]), (-1.0, [-2, 3]))]
        with tempfile.TemporaryDirectory() as folder:
            root = {"format": "spherepair results 1", "measurements": [{**row, "table": "step"} for row in rows], "context": {}}
            pathlib.Path(folder, "results.json").write_text(json.dumps(root))
            machine = Machine(folder)
        self.assertEqual(([2.0], 2), ([record.median for record in machine.records], machine.lost))

    def test_none_is_drawn_without_its_records(self):
        machine = recorded()
        machine.records, machine.sources = [], {}
        drawn = {made.name for made, _ in all_figures.made(machine) if made}
        self.assertLessEqual(drawn, {"animations", "closeup", "same-frame", "settling"})  # images


class Tables(unittest.TestCase):
    def test_crossovers_by_kind(self):
        machine = recorded()
        for cells, time_of_auto, loss in (("dense", 2, "1"), ("dense", 2.5, "1"), ("hashed", 4, "2")):
            machine.records = made_up_crossovers(cells, time_of_auto)
            self.assertEqual([["gas", "1,024", loss]], studies.crossover(machine).rows)

    def test_of_the_grid_sweeps_alone_count(self):
        def record(n, date, swept, table="grid"):
            return Record({"table": table, "backend": "opengl", "method": "collide_grid", "n": n, "order": "cold",
                           "scene": SCENE}, 1, 1, 1, f"{date} {swept}", date, swept)
        old, new, compared = record(64, "1", True), record(64, "2", True), record(4096, "3", False)
        other = record(64, "0", False, "methods")
        self.assertEqual([new, other], latest([old, compared, new, other]))
        self.assertEqual([compared, other], latest([compared, other]))

    @staticmethod
    def energies(disagreement=0.01):
        """Two backends and two searches; GLSL takes twice CUDA's energy."""
        return [Record({"table": "energy", "scene": SCENE, "n": 1000, "work": work, "backend": backend, "label": f"{backend} {work}",
                        "counter_watts": 400, "idle_counter_watts": idle, "joules_per_step": joules, "power": "instant",
                        "nanojoules_per_sphere": 1e6 * joules, "windows": [{"seconds": 10.2}],
                        "disagreement": disagreement if (backend, work) == ("opengl", "warm") else -0.02}, 1, 1, 1, "made up")
                for work in ("warm", "cold") for backend, joules, idle in (("opengl", 0.02, 110), ("cuda", 0.01, 115))]

    def test_energies(self):
        machine = recorded()
        machine.records = self.energies()
        table = energy.energy(machine)
        self.assertEqual([["grid, in cell order", "1,000", "400", "20.0", "20000", "400", "10.0", "10000", "2.00"],
                          ["grid, in random order", "1,000", "400", "20.0", "20000", "400", "10.0", "10000", "2.00"]], table.rows)
        self.assertIn("idle GPU, 110 to 115 W", table.caption)
        self.assertIn("at most 2.0 \\% apart", table.caption)

    def test_energies_whose_methods_disagree_are_left_out_and_named(self):
        machine = recorded()
        machine.records = self.energies(0.04)
        table = energy.energy(machine)
        self.assertEqual(["grid, in cell order", "1,000", "-", "-", "-", "400", "10.0", "10000", "-"], table.rows[0])
        self.assertIn("by more than 3 \\%: opengl warm.", table.caption)
        machine.records = [record for record in machine.records if record.disagreement > 0.03]
        self.assertRaises(Missing, energy.energy, machine)

    def test_transfers(self):
        machine = recorded()
        timed = {"imported": (1.9, 2.2), "step": (0.9, 1.1), "imported_pipelined": (2.4, 2.6)}

        def record(n):
            frames = [{"work": work, "draw": "none" if work == "step" else "points", "n": n, "interval_ms": interval}
                      for work, interval in timed.items()]
            frames.append({"work": "imported", "draw": "none", "n": n, "interval_ms": (9, 9)})  # alone: not in the table
            return {"id": "made up", "frames": frames, "overlaps": [
                {"transfer": "imported", "draw": "points", "n": n, "frame_ms": 2.0, "step_ms": 1.0,
                 "pipelined_ms": 2.5, "overlap": 0.5}]}

        machine.sources = {"frames.json": record(1000), "more_frames.json": record(10**8)}
        figures_of_each = ["2.00", "1.00", "2.50", "0.500 [0.200, 0.900]"]
        self.assertEqual([["imported", size, *figures_of_each] for size in ("10^3", "10^8")],
                         studies.transfer(machine).rows)


class StaleRecords(unittest.TestCase):
    """Figures and tables of records of earlier sources name what has changed."""

    def lines(self, digest):
        """The captions of one figure and of one table, and what the table's text form says."""
        machine = recorded()
        machine.records = [replace(record, recorded=({"measure": digest},)) for record in machine.records]
        table = all_tables.of_one(all_tables.methods, machine)
        one = unittest.mock.patch.object(all_figures, "modules", lambda rooms: [ratio])
        with tempfile.TemporaryDirectory() as folder, one:
            drawn, _ = figures.draw_all(machine, pathlib.Path(folder))
        captions = dict(figures.captions(machine, drawn, [table]))
        return [captions["glsl-against-cuda"], captions["methods"], all_tables.table_title(table, machine)]

    def test_it_is_named(self):
        for line in self.lines("0"):
            self.assertRegex(line, r"(\. R|; r)ecorded with earlier timing")

    def test_of_the_current_sources_nothing_is_said(self):
        for line in self.lines(sources.current()["measure"]):
            self.assertNotIn("ecorded with", line)


class Paper(unittest.TestCase):
    def test_everything_that_it_includes_is_made(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as output, laid_out_alone(but="scale"):
            figures.write_paper_inputs(pathlib.Path(folder))
            made = {path.name for path in pathlib.Path(folder).rglob("*")}
            captions, runs = (pathlib.Path(folder, name).read_text() for name in ("captions.tex", "runs.tex"))
        self.assertLessEqual({"numbers.tex", "captions.tex", "trace.tex", "runs.tex", "table1.tex", "scale.pdf", "scale.png"}, made)
        self.assertRegex(output.getvalue(), "each from a recorded run")
        self.assertNotIn("left out", output.getvalue())
        shown = {pathlib.Path(name).stem for name in made if name.endswith((".txt", ".png"))}
        self.assertEqual(set(), shown.difference(*contents.GROUPS.values()), "paper/page/contents.py lacks a title")
        digests_of = set(re.findall(r"\\definecaption\{([\w-]+)\}.*\w+:[0-9a-f]{8}\b", captions))
        self.assertEqual({"three-apis", "apis", "opening"}, digests_of, "of the paper's machine the appendix has the runs")
        for run in (recorded().id, recorded().source("counters.json")["id"]):
            self.assertIn(run, runs)


if __name__ == "__main__":
    unittest.main()
