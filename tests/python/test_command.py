# SPDX-License-Identifier: MIT
"""python -m spherepair: files, summary, messages. Packages that are not installed are stood in for."""

import contextlib
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest
from unittest import mock

import numpy as np
from support import ROOT, spherepair

from spherepair import __main__ as command

POINTS = np.random.default_rng(1).uniform(0, 5, (80, 3))
CELL = np.array([[5.0, 0, 0], [1, 5, 0], [0, 0, 5.5]])
EXTXYZ = '80\nLattice="5 0 0 1 5 0 0 0 5.5" pbc="T T F" Properties=species:S:1:pos:R:3\n' + "".join(
    f"Ar {x!r} {y!r} {z!r}\n" for x, y, z in POINTS.tolist())


class Frame:
    """Stands for ase.Atoms."""

    cell, pbc = CELL, np.array([True, True, False])

    def get_positions(self):
        return POINTS


def module(name, **members):
    made = types.ModuleType(name)
    made.__dict__.update(members)
    return made


def standing_in(**modules):
    """sys.modules with these packages and none of the others that read files."""
    absent = dict.fromkeys(("ase", "ase.io", "MDAnalysis", "gsd", "gsd.hoomd", "meshio"))
    return mock.patch.dict("sys.modules", {**absent, **{name.replace("_", "."): made for name, made in modules.items()}})


class Trajectory:
    """Stands for what gsd.hoomd.open gives."""

    def __init__(self, path, mode):
        box = types.SimpleNamespace(box=[5, 5, 5.5, 0.2, 0, 0], dimensions=2 if "flat" in path else 3)
        self.frames = [types.SimpleNamespace(configuration=box, particles=types.SimpleNamespace(position=POINTS.astype("f4")))]

    def __enter__(self):
        return self.frames

    def __exit__(self, *_):
        pass


ASE = {"ase": module("ase"), "ase_io": module("ase.io", read=lambda path, index: Frame())}


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "argon.extxyz"
        self.file.write_text(EXTXYZ)

    def run_it(self, *words):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = command.main(["pairs", *map(str, words), "--backend", "cpu"])
        return status, out.getvalue(), err.getvalue()

    def check_summary(self, text, path, expected):
        i, d = expected
        for line in (f"file        {path}, read with ", "points      80\n", "cutoff      1\n", f"pairs       {len(i)}\n",
                     f"distances   {d.min():.10g} to {d.max():.10g}\n", f"{2 * len(i) / 80:.4g} on average\n", "backend     cpu: "):
            self.assertIn(line, text)

    def test_a_summary_and_an_archive(self):
        output = self.folder / "pairs.npz"
        with standing_in(**ASE):
            status, text, errors = self.run_it(self.file, "--cutoff", 1, "--output", output)
        self.assertEqual((0, ""), (status, errors))
        expected = dict(zip("ijSd", spherepair.neighbor_list("ijSd", POINTS, 1.0, CELL, Frame.pbc, half=True)))
        self.check_summary(text, self.file, (expected["i"], expected["d"]))
        self.assertIn("box         5 0 0; 1 5 0; 0 0 5.5, periodic along a b\n", text)
        with np.load(output) as found:
            self.assertEqual(set("ijSd"), set(found))
            for name, column in expected.items():
                np.testing.assert_array_equal(column, found[name])

    def test_other_packages(self):
        box = types.SimpleNamespace(triclinic_dimensions=CELL)
        universe = types.SimpleNamespace(atoms=types.SimpleNamespace(positions=POINTS),
                                         trajectory=types.SimpleNamespace(ts=box))
        mesh = types.SimpleNamespace(points=POINTS)
        full = spherepair.neighbor_list("id", POINTS, 1.0, CELL, half=True)
        near = spherepair.neighbor_list("id", POINTS.astype("f4"), 1.0, CELL, half=True)
        flat = spherepair.neighbor_list("id", POINTS.astype("f4"), 1.0, CELL, Frame.pbc, half=True)
        cases = ((self.file, "MDAnalysis", full, {"MDAnalysis": module("MDAnalysis", Universe=lambda path: universe)}),
                 (self.folder / "a.gsd", "gsd", near, {"gsd": module("gsd"), "gsd_hoomd": module("gsd.hoomd", open=Trajectory)}),
                 (self.folder / "flat.gsd", "gsd", flat, {"gsd": module("gsd"), "gsd_hoomd": module("gsd.hoomd", open=Trajectory)}),
                 (self.file, "meshio", spherepair.neighbor_list("id", POINTS, 1.0, half=True),
                  {"meshio": module("meshio", read=lambda path: mesh)}))
        for path, name, expected, packages in cases:
            path.write_text(EXTXYZ)
            with self.subTest(package=name), standing_in(**packages):
                status, text, errors = self.run_it(path, "--cutoff", 1)
                self.assertEqual((0, ""), (status, errors))
                self.assertIn(f"read with {name}\n", text)
                self.check_summary(text, path, expected)

    def test_no_pairs(self):
        with standing_in(**ASE):
            status, text, _ = self.run_it(self.file, "--cutoff", 0)
        self.assertEqual(0, status)
        self.assertIn("pairs       0\n", text)
        self.assertNotIn("distances", text)

    def test_messages(self):
        def unreadable(path, index):
            raise KeyError("not my format")
        cannot = {**ASE, "ase_io": module("ase.io", read=unreadable)}
        cases = (({}, self.file, 1, "cannot be read: install ase or MDAnalysis or meshio, for example with: "
                                    "python3 -m pip install ase"),
                 ({}, self.folder / "a.gsd", 1, "install gsd or ase"),
                 (cannot, self.file, 1, "cannot be read (ase: KeyError: 'not my format'): install MDAnalysis or meshio"),
                 (ASE, self.folder / "nothing.xyz", 1, "No such file or directory"),
                 (ASE, self.file, -1, "cutoff is -1"),
                 (ASE, self.file, "nan", "cutoff is nan"))
        (self.folder / "a.gsd").write_text("")
        for packages, path, cutoff, message in cases:
            with self.subTest(message=message), standing_in(**packages):
                status, text, errors = self.run_it(path, f"--cutoff={cutoff}")
                self.assertEqual((1, ""), (status, text))
                self.assertIn(message, errors)
                self.assertTrue(errors.startswith("spherepair: "))

    def test_an_output_that_cannot_be_written(self):
        with standing_in(**ASE):
            status, text, errors = self.run_it(self.file, "--cutoff", 1, "--output", self.folder / "none" / "a.npz")
        self.assertEqual((1, ""), (status, text))
        self.assertIn("No such file or directory", errors)

    def test_as_a_program(self):
        for words, status, text in ((["--version"], 0, f"spherepair {spherepair.__version__}\n"), (["pairs"], 2, ""),
                                    (["pairs", "--help"], 0, None)):
            run = subprocess.run([sys.executable, "-m", "spherepair", *words], capture_output=True, text=True, cwd=ROOT / "python")
            self.assertEqual(status, run.returncode, run.stderr)
            self.assertIn("--cutoff R" if text is None else text, run.stdout)

    def test_the_code_of_the_manual(self):
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs/python.md").read_text(), re.S)
        moved = []
        names = {"move": lambda positions: moved.append(np.add(positions, 0.01, out=positions)), "use": lambda *columns: None}
        with contextlib.redirect_stdout(io.StringIO()) as out, tempfile.TemporaryDirectory() as names["folder"]:
            for block in blocks:
                exec(block, names)
        self.assertRegex(out.getvalue(), r"^\d+ neighbours, \d+ overlaps, \{'cpu': None")
        self.assertEqual((100, 4), (len(moved), len(blocks)))

    def test_a_file_through_ase(self):
        try:
            import ase  # noqa: F401
        except ImportError:
            self.skipTest("ASE is not installed")
        status, text, errors = self.run_it(self.file, "--cutoff", 1)
        self.assertEqual((0, ""), (status, errors))
        self.check_summary(text, self.file, spherepair.neighbor_list("id", POINTS, 1.0, CELL, Frame.pbc, half=True))


if __name__ == "__main__":
    unittest.main()
