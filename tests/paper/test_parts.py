# SPDX-License-Identifier: MIT
"""The parts of a recording: the command of each process, and what a machine must have."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper import parts  # noqa: E402  (the path must be set first)


class Parts(unittest.TestCase):
    def test_later_processes_repeat_the_times_of_the_apis_alone(self):
        results = next(part for part in parts.GPU if part.name == "results")
        first, second = (parts.Run(results, process).command("OUT")[0] for process in (1, 2))
        self.assertLessEqual(parts.TIMES.split(","), first[first.index("--tables") + 1].split(","))
        self.assertEqual([parts.TIMES, "opengl,cuda", "OUT"], [second[second.index(name) + 1] for name in ("--tables", "--backends", "--results")])

    def test_opengl_without_extensions_needs_opengl(self):
        core = next(part for part in parts.GPU if part.name == "sweep_core")
        devices = [{"name": name, "open": True, "software": False} for name in ("opengl", "cuda")]
        self.assertEqual("", parts.missing_needs(core, devices))
        self.assertEqual("needs opengl-core, opengl", parts.missing_needs(core, devices[1:]))


if __name__ == "__main__":
    unittest.main()
