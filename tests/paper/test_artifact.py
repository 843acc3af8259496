# SPDX-License-Identifier: MIT
"""ARTIFACT.md's claims of speed hold in the recorded runs, within their tolerances, and its commands name existing
tests. Needs no matplotlib."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper import parts  # noqa: E402
from paper.numbers import leads  # noqa: E402  (the path must be set first)
from paper.numbers.ablations import pairs_of as on_and_off  # noqa: E402
from paper.numbers.crossovers import crossovers_by_kind  # noqa: E402
from paper.numbers.derived import cost, matched, pairs_of  # noqa: E402
from paper.numbers.pareto import study  # noqa: E402
from paper.numbers.prose_accuracy import bandwidth  # noqa: E402
from paper.numbers.ratios import time_ratio  # noqa: E402


APIS = ("opengl", "cuda")
CLAIMS = (ROOT / "ARTIFACT.md").read_text()


def row(number):
    return re.search(rf"^\| {number} \|.*$", CLAIMS, re.MULTILINE)[0]


class Speed(unittest.TestCase):
    """One method per row; each first finds its numbers in the row, so that neither changes without the other."""

    @classmethod
    def setUpClass(cls):
        cls.machine = recorded()

    def stated(self, number, *words):
        for word in words:
            self.assertIn(word, row(number))

    def scale(self, **wanted):
        return self.machine.one(table="scale", **wanted)

    def test_4a(self):
        self.stated("4a", "≤ 0.060 ms", "≥ 3.3·10¹²", "| 5 % |")
        for scene in ("random", "uniform"):
            self.assertLessEqual(self.scale(scene=scene, n=16384, backend="cuda").median, 0.060 * 1.05)
            large = self.scale(scene=scene, n=2**20, backend="cuda")
            self.assertGreaterEqual(0.5 * large.n * (large.n - 1) / (1e-3 * large.median), 3.3e12 / 1.05)

    def test_4b(self):
        self.stated("4b", "at most 1.05x", "65,536", "1.2x at 16,384", "3 percentage points")
        for scene in ("random", "uniform"):
            for glsl, cuda in matched(self.machine, table="scale", scene=scene):
                bound = 1.05 if glsl.n >= leads.LARGE else 1.2 if glsl.n == 16384 else 9
                self.assertLessEqual(glsl.median / cuda.median, bound + 0.03, f"{scene}, {glsl.n}")

    def test_4c(self):
        self.stated("4c", "≤ 5 %", "collide_triangle", "2 percentage points")
        for exact, naive in pairs_of(self.machine):
            if exact.method == "collide_triangle":
                self.assertLessEqual(cost(naive, exact)[0], 5 + 2, exact.label)

    def test_4d(self):
        self.stated("4d", "≤ 0.08 ms", "| 5 % |")
        for name in APIS:
            self.assertLessEqual(self.machine.one(table="step", n=16384, backend=name).median, 0.08 * 1.05)

    def test_4e(self):
        self.stated("4e", "for whole steps", "up to 16,384", "from 262,144 on all pairs take OpenGL 0.93x to 1.03x CUDA's time", "3 percentage points")
        for entry in leads.contests(self.machine):
            if entry.n <= 16384 or entry.where == "whole steps":
                self.assertGreater(entry.compared.low, 1, entry)
            elif entry.n >= 262144:
                self.assertTrue(0.93 - 0.03 <= entry.ratio <= 1.03 + 0.03, entry)

    def test_4f(self):
        self.stated("4f", "≥ 85 %", "at most 1.05x", "at least twice as fast")
        record = self.machine.source("precision_1e8.json")
        times = {}
        for name in APIS:
            copied = next(copy["bytes_per_second"] for copy in record["copies"] if copy["backend"] == name)
            self.assertGreaterEqual(bandwidth(record, name), 0.85 * copied)
            rows = self.machine.need(table="precision", backend=name, precision="float32", n=10**8, work="move")
            times[name] = {entry.method: entry.median for entry in rows}
            self.assertGreaterEqual(times[name]["paper"], 2 * times[name]["anchored"])
        self.assertLessEqual(times["opengl"]["paper"] / times["cuda"]["paper"], 1.05)

    def test_5d(self):
        self.stated("5d", "first 1,000", "at least 2.5·10⁷", "--threads 2", "| 10 % |")
        machine = recorded("llvmpipe")
        gas = machine.one(table="gas_steps", n=10**6, backend="cpu")
        self.assertEqual(1000, gas.steps)
        self.assertEqual(2, machine.source("contacts_cpu.json")["backends"][0]["details"]["threads"])
        self.assertGreaterEqual(gas.sphere_steps_per_second, 2.5e7)

    def test_6b(self):
        self.stated("6b", "`impact` f32 ≤ 2e-4 m for dt ≥ 2⁻⁶", "`anchored` f32 ≤ 1e-5", "compensated ≤ 1e-9",
                  "f64 ≤ 1e-10")
        bounds = {"float32": 1e-5, "compensated": 1e-9, "float64": 1e-10}
        for entry in study(self.machine):
            if entry.method == "anchored":
                self.assertLessEqual(entry.error_m, bounds[entry.precision], entry.label)
            elif entry.method == "impact" and entry.dt >= 2**-6:
                self.assertLessEqual(entry.error_m, max(2e-4, bounds[entry.precision]), entry.label)

    def test_7d(self):
        self.stated("7d", "none of a GPU", "six kinds")
        found = crossovers_by_kind(self.machine)
        self.assertEqual(6, len(found))
        losses = [loss for by_backend in found.values() for name in APIS for loss in by_backend[name].losses]
        self.assertLessEqual(max(losses), 1.1)

    def test_7e(self):
        claims = {"counts_read": (10**6, 40, APIS), "exact_stages": (10**6, 10, APIS), "order": (10**6, 1.4, APIS),
                  "cells": (10**6, 1.4, APIS), "vector_loads": (10**6, 2, APIS), "own_clear": (10**6, 2, ("opengl",)),
                  "batch": (10**6, 2, ("opengl",)), "overlap": (16384, 1.2, APIS)}
        self.stated("7e", "unrequested counts ≥ 40 times", "filter ≥ 10", "≥ 1.4", "own clear ≥ 2", "one by one ≥ 2",
                    "overlapping steps ≥ 1.2")
        found = {(on.option, on.n, on.backend): off.median / on.median for on, off in on_and_off(self.machine)}
        for option, (n, least, apis) in claims.items():
            for name in apis:
                self.assertGreaterEqual(1.1 * found[option, n, name], least, f"{option}, {name}")

    def test_7f(self):
        self.stated("7f", "at most 1.10x", "16,384, 10⁶ and 10⁷", "| 5 % |")
        for n in (16384, 10**6, 10**7):
            for name in APIS:
                integers, in_order = (self.machine.one(table="contact_sums", n=n, backend=name, sums=sums)
                                      for sums in ("integers", "in_order"))
                self.assertLessEqual(time_ratio(integers, in_order).middle, 1.1 * 1.05, f"{name}, {n}")

    def test_7g(self):
        self.stated("7g", "at least 10¹⁰", "at most 1.10x", "1.36x at 10⁶", "| 5 % |")
        for n, most in ((10**6, 1.36), (10**7, 1.1), (10**8, 1.1)):
            glsl, cuda = (self.machine.one(table="gas_steps", n=n, backend=name) for name in APIS)
            self.assertLessEqual(time_ratio(glsl, cuda).middle, most * 1.05, str(n))
            self.assertGreaterEqual(n / cuda.parameters["seconds_per_step"], 1e10 / 1.05, str(n))

    def test_7h(self):
        self.stated("7h", "at most a third", "10⁶ and 10⁷ spheres", "| 5 % |")
        for record, n in (("contacts_rest", 10**6), ("contacts_rest_1e7", 10**7)):
            (bed,) = self.machine.source(f"{record}.json")["beds"]
            self.assertGreaterEqual(bed["n"], n)
            self.assertEqual(1, bed["unmoved"])
            ratios = {row["backend"]: row["awake_over_this"]["ratio"] for row in bed["steps"] if row["sleeping"]}
            self.assertEqual(set(APIS), ratios.keys())
            for name, ratio in ratios.items():
                self.assertGreaterEqual(1.05 * ratio, 3, f"{name}, {n}")

    def test_8c(self):
        self.stated("8c", "≤ 0.08, 0.20 and 0.30 ms in CUDA and in GLSL", "| 10 % |")
        for n, most in ((16384, 0.08), (10**6, 0.20), (10**7, 0.30)):
            for name in APIS:
                frame = self.machine.one(table="draw", draw="compute", work="frame", place="outside", n=n, backend=name)
                self.assertLessEqual(frame.median, 1.1 * most, frame.label)

    def test_8g(self):
        """No part of the list, as it needs an X server."""
        self.stated("8g", "at most 1.1x the time off screen", "| 10 % |", "`paper/data/h100/window`")
        for api in APIS:
            window, off_screen = (self.machine.one(table="window", work="loop", n=10**6, backend=api, window=shown).median
                                  for shown in (True, False))
            self.assertLessEqual(window, 1.1 * 1.1 * off_screen, api)


class Commands(unittest.TestCase):
    def test_every_named_test_exists(self):
        sources = "".join(path.read_text() for path in (ROOT / "tests").rglob("*") if path.suffix in (".cpp", ".txt"))
        for name in re.findall(r"\./check -R ([\w.]+)", CLAIMS):
            self.assertTrue(name in sources or name == "lint", name)
        for pattern in re.findall(r"\*(Row\d+)", CLAIMS):
            self.assertIn(pattern, sources)

    def test_the_parts_of_a_recording_are_those_of_the_program(self):
        rows = re.findall(r"^\| (`\w[^|]*`) \| (\d+) \| (\d+) \|", CLAIMS, re.M)
        stated = {name: (int(minutes), int(processes)) for names, minutes, processes in rows
                  for name in re.findall(r"`([\w-]+)`", names)}
        for part in parts.GPU:
            self.assertEqual((part.minutes, part.processes), stated.pop(part.name, None), part.name)
        self.assertEqual({}, stated)
        for processes, words in ((5, r"in total (\d+),"), (1, r"(\d+) for one process")):
            total = sum(run.part.minutes for run in parts.runs(parts.GPU, processes))
            self.assertEqual(str(total), re.search(words, CLAIMS)[1])

    def test_no_table_is_split(self):
        """A blank line within a table would split it."""
        lines = CLAIMS.splitlines()
        for before, line in zip(lines, lines[1:]):
            if line.startswith("|") and not before.startswith("|"):
                self.assertEqual("", before)
        for table in re.split(r"\n\n", CLAIMS):
            if table.startswith("|"):
                self.assertRegex(table.splitlines()[1], r"^\|[-|]+\|$", table[:60])
                self.assertEqual(1, len({line.count("|") for line in table.splitlines()}), table[:60])


if __name__ == "__main__":
    unittest.main()
