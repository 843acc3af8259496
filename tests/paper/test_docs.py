# SPDX-License-Identifier: MIT
"""README.md and docs/ say what the records say, their links lead to files, and the README's first screen has the answer.
Needs no matplotlib."""
import pathlib
import re
import statistics
import sys
import unittest
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from changed_records import recorded, three_apis  # noqa: E402  (the path must be set first)
from paper import docs_facts  # noqa: E402
from paper.numbers import apis  # noqa: E402
from paper.numbers.derived import stage_ratios, timer_floor  # noqa: E402
from paper.records import Missing, recorded_code  # noqa: E402

TIMES = ("samples_ms", "median_ms", "plain_ms", "interval_ms", "device_stages_ms", "device_stages_interval_ms")
PAGES = [ROOT / name for name in ("README.md", "ARTIFACT.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted((ROOT / "docs").rglob("*.md"))


def changed(wanted, **altered):
    """The recorded machine with parameters of some records altered."""
    machine = recorded()
    machine.records = [replace(record, parameters={**record.parameters, **altered}) if wanted(record) else record
                       for record in machine.records]
    return machine


def scaled(value, factor):
    if isinstance(value, dict):
        return {name: scaled(each, factor) for name, each in value.items()}
    return [scaled(each, factor) for each in value] if isinstance(value, (list, tuple)) else factor * value


def slower(wanted, factor, machine):
    """This machine with times of some records made longer."""
    def longer(fields):
        return {name: [longer(run) for run in value] if name == "processes" else scaled(value, factor) if name in TIMES else value
                for name, value in fields.items()}
    machine.records = [replace(record, median=factor * record.median, low=factor * record.low, high=factor * record.high,
                               parameters=longer(record.parameters)) if wanted(record) else record for record in machine.records]
    return machine


def over(found, way, other):
    """Ratios of times of short steps."""
    return [apis.fastest(found, way, n).median / apis.fastest(found, other, n).median for n in apis.sizes(found, apis.SHORT)]


def contradicted(machine, three):
    """The words of the README's answer that these records contradict."""
    steps, lines = apis.rows(three, "all_pairs"), recorded_code()["host"]
    api, language = over(steps, "OpenGL", "Vulkan"), over(steps, "Vulkan", apis.ONE_STEP)  # the same GLSL; another language as well
    alone = [row.ratio[0] for row in stage_ratios(machine) if row.cuda_ms > 10 * timer_floor(machine)]
    holds = {"Kernels alone: nearly as fast": abs(statistics.median(alone) - 1) < 0.05,
             "Short steps: the API decides": all(a > b for a, b in zip(api, language)),
             "comes near CUDA; OpenGL does not": max(language) < 1.3 < max(over(steps, "OpenGL", apis.ONE_STEP)),
             "CUDA graphs of many steps are ahead of both": min(over(steps, "Vulkan", apis.MANY_STEPS)) > 1.05,
             "CUDA takes the least host code, Vulkan the": lines["cuda"] < lines["opengl"] < lines["vulkan"]}
    return [words for words, held in holds.items() if not held]


class Records(unittest.TestCase):
    def test_the_pages_say_what_is_recorded(self):
        machine = recorded()
        for page in docs_facts.PAGES:
            text = (ROOT / page).read_text()
            self.assertEqual(docs_facts.updated(page, text, machine), text, "paper/figures.py --headline brings it up to date")

    def test_another_number_or_a_lost_marker_is_found(self):
        machine, text = recorded(), (ROOT / "docs/motion.md").read_text()
        self.assertEqual(text, docs_facts.updated("docs/motion.md", text.replace("| 6.6 |", "| 9.6 |"), machine))
        with self.assertRaises(Missing):
            docs_facts.updated("docs/motion.md", text.replace("<!-- wrong-pairs:", "<!-- wrong:"), machine)

    def test_errors_that_depend_on_the_backend_are_refused(self):
        with self.assertRaisesRegex(Missing, "the text says"):
            docs_facts.errors(changed(lambda record: record.table == "precision" and record.backend == "cuda", error_m=9.0))

    def test_the_bold_words_of_the_answer_hold(self):
        readme = (ROOT / "README.md").read_text()
        self.assertEqual([], contradicted(recorded(), three_apis()))
        many = lambda record: record.path.startswith("graph_steps") if record.table == "launches" else False  # noqa: E731
        opengl, vulkan = (lambda record, name=name: record.backend == name for name in ("opengl", "vulkan"))
        for words, machine, three in (
                (["Short steps: the API decides", "comes near CUDA; OpenGL does not"], recorded(), slower(opengl, 0.5, three_apis())),
                (["Short steps: the API decides", "comes near CUDA; OpenGL does not"], recorded(), slower(vulkan, 5, three_apis())),
                (["CUDA graphs of many steps are ahead of both"], recorded(), slower(many, 2, three_apis())),
                (["Kernels alone: nearly as fast"], slower(opengl, 5, recorded()), three_apis())):
            self.assertTrue(all(each in readme for each in words))
            self.assertEqual(words, contradicted(machine, three))


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
        for word in ("OpenGL", "CUDA", "NVIDIA's H100 and H200", "Vulkan", "Kernels alone", "Short steps", "Exceptions"):
            self.assertIn(word, first)


if __name__ == "__main__":
    unittest.main()
