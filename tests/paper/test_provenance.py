# SPDX-License-Identifier: MIT
"""Each figure names the runs and hosts of the records that it shows."""
import importlib.util
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
if importlib.util.find_spec("matplotlib") is None:
    print("SKIPPED: figures need matplotlib (python3-matplotlib)")
    sys.exit(77)

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper import all_figures, figures, folders  # noqa: E402
from paper.numbers.pareto import study  # noqa: E402
from paper.plots import contact_precision, grid_phases, set_errors, step, work_precision, work_precision_overlay  # noqa: E402


class Provenance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.machine = recorded()

    def runs(self, module):
        self.machine.used.clear()
        figures.style.plt.close(module.draw(self.machine))
        return all_figures.runs_of(module, self.machine)

    def test_every_run_that_is_drawn_is_named(self):
        for module in (work_precision, work_precision_overlay):
            self.assertEqual({row.source for row in study(self.machine)}, set(self.runs(module)))
        self.assertEqual({self.machine.source("contacts.json")["id"]}, set(self.runs(contact_precision)))
        self.assertEqual({row.source for row in grid_phases.drawn(self.machine)}, set(self.runs(grid_phases)))
        self.assertEqual([self.machine.id], self.runs(step))

    def test_hosts_are_those_of_the_runs(self):
        """Not those of the main run, whose hosts had other threads."""
        for module in (work_precision, contact_precision, set_errors, step):
            ids = self.runs(module)
            wanted = {host for root in self.machine.sources.values() if root["id"] in ids for host in root["hosts"]}
            title = self.machine.title_of(ids)
            self.assertEqual(" and ".join(sorted(wanted)), " and ".join(sorted(re.search(r"CPU: (.*); run", title)[1].split(" and "))))

    def test_a_host_has_its_threads_or_is_not_named(self):
        context = {"machine": {"cpu": "Abacus(R)", "hardware_threads": 64}}
        cpu = {"name": "cpu", "details": {"threads": 16}}
        for root, text in (({}, "not named by the record"), ({"context": context}, "Abacus, 64 hardware threads"),
                           ({"context": context, "backends": [cpu]}, "Abacus, 16 threads")):
            self.assertEqual(text, folders.host_of(root))


if __name__ == "__main__":
    unittest.main()
