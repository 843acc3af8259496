# SPDX-License-Identifier: MIT
"""README.md and docs/ say what the records say, their links lead to files, and the README's first screen has the answer.
Needs no matplotlib."""
import pathlib
import re
import sys
import unittest
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from paper import front_page  # noqa: E402  (the path must be set first)
from paper.records import DATA, MAIN, Machine, Missing  # noqa: E402

PAGES = [ROOT / name for name in ("README.md", "ARTIFACT.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted((ROOT / "docs").rglob("*.md"))


def slower(backend, factor, **wanted):
    """The recorded machine with these times of one backend made longer."""
    machine = Machine(DATA / MAIN)
    def changed(record):
        if record.backend != backend or not record.matches(wanted):
            return record
        samples = [factor * sample for sample in record.parameters.get("samples_ms", [])]
        return replace(record, median=factor * record.median, low=factor * record.low, high=factor * record.high,
                       parameters={**record.parameters, "samples_ms": samples})
    machine.records = [changed(record) for record in machine.records]
    return machine


class Records(unittest.TestCase):
    def test_the_pages_say_what_is_recorded(self):
        machine = Machine(DATA / MAIN)
        for page in front_page.PAGES:
            text = (ROOT / page).read_text()
            self.assertEqual(front_page.updated(page, text, machine), text, "paper/figures.py --headline brings it up to date")

    def test_another_number_or_a_lost_marker_is_found(self):
        machine, text = Machine(DATA / MAIN), (ROOT / "README.md").read_text()
        self.assertEqual(text, front_page.updated("README.md", text.replace("**Short steps: no.**", "Short steps are 9x."), machine))
        with self.assertRaises(Missing):
            front_page.updated("README.md", text.replace("<!-- facts:", "<!-- facs:"), machine)

    def test_an_answer_that_the_records_contradict_is_refused(self):
        for make, backend, factor, wanted in (
                (front_page.short_steps, "cuda", 5, {"table": "step"}),
                (front_page.exceptions, "cuda", 5, {"method": "collide_tensor"}),
                (front_page.exceptions, "cuda", 5, {"kind": "radii"}),
                (front_page.exceptions, "glsl", 5, {"kind": "one_cell"})):
            make(Machine(DATA / MAIN))
            with self.assertRaisesRegex(Missing, "the text says"):
                make(slower(backend, factor, **wanted))


class Pages(unittest.TestCase):
    def test_every_link_leads_to_a_file(self):
        for page in PAGES:
            targets = re.findall(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"", page.read_text())
            for target in ("".join(each).split("#")[0] for each in targets):
                if target and "://" not in target:
                    self.assertTrue((page.parent / target).exists(), f"{page.name} links to {target}")

    def test_every_page_of_docs_can_be_reached_from_the_readme(self):
        readme = (ROOT / "README.md").read_text()
        for page in sorted((ROOT / "docs").glob("*.md")):
            self.assertIn(f"(docs/{page.name})", readme)

    def test_the_first_screen_has_question_answer_and_machine(self):
        lines = (ROOT / "README.md").read_text().splitlines()
        self.assertLessEqual(len(lines), 100)
        first = "\n".join(lines[:25])
        for word in ("OpenGL", "CUDA", "NVIDIA H100", "Vulkan", "Kernels alone", "Short steps", "exceptions"):
            self.assertIn(word, first)


if __name__ == "__main__":
    unittest.main()
