# SPDX-License-Identifier: MIT
"""Every figure can be drawn: from recorded runs, or from made-up records if none are recorded yet."""
import contextlib
import importlib.util
import io
import json
import pathlib
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

from changed_records import recorded, three_apis  # noqa: E402  (the path must be set first)
from paper import all_figures, figures, sources, style  # noqa: E402
from paper.numbers.derived import GRID_BYTES  # noqa: E402
from paper.page import contents  # noqa: E402
from paper.plots import ratio  # noqa: E402
from paper.records import Machine, Missing, Record, latest  # noqa: E402
from paper.tables import all_tables, energy, studies  # noqa: E402

SCENE = {"name": "uniform", "packing_fraction": 0.3}


def made_up(table, times, **parameters):
    return [Record({"table": table, "scene": SCENE, "n": n, "label": "made up",
                    "samples_ms": [factor * 1e-6 * n * t for factor in (0.9, 1, 1, 1.1)], **parameters}, 1e-6 * n * t,
                   0.9e-6 * n * t, 1.1e-6 * n * t, "made up") for t in times for n in (1024, 1000000)]


def made_up_records():
    rows = made_up("grid", [9], backend="cpu", method="collide_grid", order="cold")
    for backend in ("opengl", "cuda"):
        for method, order, time in (("grid", "cold", 2), ("grid", "warm", 1), ("triangle", "cold", 3)):
            rows += made_up("grid", [time], backend=backend, method=f"collide_{method}", order=order,
                            share_of_floor=0.5, peak_per_second=1e12, device_stages_ms={"collide": 1.0},
                            device_stages_interval_ms={"collide": [0.9, 1.1]})
            for row in rows[-2:]:
                row.parameters["floor_ms"] = 1e-9 * GRID_BYTES[order] * row.n
        rows += made_up("draw", [1], backend=backend, draw="compute", place="outside", work="frame")
        rows += made_up("interop", [1], backend=backend, way=f"map from {backend}")
        for work in ("all_pairs", "grid"):
            rows += made_up("launches", [1], backend=backend, work=work, path="waited")
        for on in (True, False):
            rows += made_up("ablation", [1 if on else 2], backend=backend, option="kept order", on=on)
        for precision in ("float32", "float64"):
            rows += made_up("precision", [1, 2], backend=backend, method="paper", precision=precision, dt=0.0625,
                            error_m=1e-3, simulated_s=10, work="move")
        for sums in ("integers", "in_order", "atomics"):
            for restitution in (1, 0.9):
                rows += made_up("contact_runs", [1, 2], backend=backend, law="spring", restitution=restitution, sums=sums,
                                steps_a_contact=10, steps=1000, position=1e-3)
    return rows


def made_up_sets():
    """A minimal record of `spherepair sets`."""
    error = {"right": 100, "missed": 3, "extra": 2}
    motion = [{"method": "paper", "precision": "float32", "k": 6, "dt": 1 / 64, "offset": offset, "whole_missed": 0,
               "whole_extra": 0, **error} for offset in (0, 1e5)]
    times = {"median_ms": 1.0, "interval_ms": [0.9, 1.1]}
    exactness = [{"backend": name, "scene": "far", "n": 1024, "exact": times, "naive": times, **error}
                 for name in ("cpu", "opengl")]
    contacts = [{"backend": "opengl", "distance": distance, "pairs": 100, "missed": 8, "deviation": 2.8,
                 "swept_missed": 0} for distance in (1.0, 3.0)]
    return {"format": "spherepair sets 1", "id": "made up", "settings": {"seconds": 10}, "motion": motion,
            "storage": [{"precision": "float32", "offset": 1e5, **error}], "exactness": exactness,
            "contacts": contacts}


def made_up_crossovers(cells, time_of_auto):
    square, grid = {"name": "collide_square", "block": 32}, {"name": "collide_grid", "cells": cells}
    return [record for n, times, taken in ((64, (1, 3, 3, 1), square), (1024, (9, 2, 4, time_of_auto), grid))
            for way, time in zip(("collide_square/32", "dense", "hashed", "auto"), times)
            for record in [Record({"table": "crossover", "kind": "gas", "way": way, "n": n, "backend": "opengl",
                                   "choice": taken, "scene": SCENE, "label": "made up", "contest": "made up",
                                   "samples_ms": [time * factor for factor in (0.99, 1, 1, 1, 1, 1, 1.01)]}, time, time, time,
                                  "made up")]]


class Figures(unittest.TestCase):
    def draw(self, machine):
        left_out = []
        for made, reason in all_figures.made(machine):
            if reason:
                left_out.append(reason[0])
            else:
                style.plt.close(made.figure)
                self.assertTrue(made.caption)
        return left_out

    def test_each_is_drawn_if_its_records_exist(self):
        machine = recorded()
        kept = [r for r in machine.records if r.table not in ("grid", "draw", "interop", "ablation", "precision")]
        machine.records = kept + made_up_records()
        machine.sources["sets.json"] = made_up_sets()
        self.assertEqual(["three-apis"], self.draw(machine))  # of OpenGL and CUDA alone
        machine.records += [record for record in three_apis().records if record.table == "launches"]
        self.assertEqual([], self.draw(machine))

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
        drawn = {module.NAME for module in all_figures.modules()} - set(self.draw(machine))
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
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as output:
            figures.write_paper_inputs(pathlib.Path(folder))
            made = {path.name for path in pathlib.Path(folder).rglob("*")}
        self.assertLessEqual({"numbers.tex", "captions.tex", "trace.tex", "runs.tex", "table1.tex", "scale.pdf", "scale.png"}, made)
        self.assertRegex(output.getvalue(), "each from a recorded run")
        shown = {pathlib.Path(name).stem for name in made if name.endswith((".txt", ".png"))}
        self.assertEqual(set(), shown.difference(*contents.GROUPS.values()), "paper/page/contents.py lacks a title")


if __name__ == "__main__":
    unittest.main()
