# SPDX-License-Identifier: MIT
"""The page of ./reproduce: its answer, its parts, and that recorded figures are drawn once."""
import importlib.util
import io
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock
from dataclasses import replace

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
if importlib.util.find_spec("matplotlib") is None:
    print("SKIPPED: figures need matplotlib (python3-matplotlib)")
    sys.exit(77)

from changed_records import laid_out_alone  # noqa: E402  (the path must be set first)
from changed_records import recorded as recorded_machine  # noqa: E402

from paper.numbers.contests import SHORT, Contest  # noqa: E402
from paper.numbers.ratios import Ratio  # noqa: E402
from paper.page import answer, index, recorded, report  # noqa: E402
from paper.page.html_table import as_html  # noqa: E402
from paper.progress import Progress  # noqa: E402
from paper.records import Machine, Missing  # noqa: E402
from paper.tables.tabular import Table  # noqa: E402

ANSWER = ("Short steps are <so>.", "On the recorded GPU, OpenGL takes 2.00x CUDA's time.")


def item(name, caption="", table=""):
    return report.Item(name, caption, f"runs of {name}", () if table else (770, 300), table)


def reports():
    there = report.Report("h100", "GPU 100", True, "Equal: 9 sets.", ["CUDA: GPU 100"], [], ANSWER, items=[
        item("grid", "The grid, there."), item("scale", "Scale."), item("ratio-by-duration", "By duration."),
        item("claims", table="<table></table>"), item("unheard-of", "After 2^{-6} s."), report.Item("closeup", "", "runs", (9, 9), rendered=True)])
    here = report.Report("run", "software", False, "Equal: 12 sets.", ["CUDA: did not run: no <GPU>"], ["The machine was busy."],
                         why_not="No GPU was found.", items=[item("grid", "The grid, here."), item("scale", "Scale.")],
                         left_out={"claims": "x", "naive": "y"})
    return [there, here]


class Page(unittest.TestCase):
    def setUp(self):
        self.page = index.page_of(reports())

    def in_order(self, *parts):
        places = [self.page.find(part) for part in parts]
        self.assertNotIn(-1, places, parts)
        self.assertEqual(sorted(places), places, parts)

    def test_opens_with_the_answer_a_figure_and_the_claims(self):
        self.in_order("<h1>Short steps are &lt;so&gt;.</h1>", "OpenGL takes 2.00x", "Equal: 12 sets.", "No GPU was found.",
                      "The machine was busy.", "ratio-by-duration.png", 'id="claims"', "id=contents", 'id="speed"', 'id="grid"')
        self.assertEqual(1, self.page.count("ratio-by-duration.png\"><img"))

    def test_every_link_has_its_target(self):
        targets = set(re.findall(r'id="?([\w-]+)', self.page))
        links = set(re.findall(r'href="#([\w-]+)"', self.page))
        self.assertLessEqual({"speed", "grid", "scale-and-limits", "unheard-of"}, links)
        self.assertEqual(set(), links - targets)

    def test_a_caption_of_both_machines_is_given_once_and_below(self):
        self.assertEqual(1, self.page.count("Scale."))
        self.in_order("h100/grid.png", "The grid, there.", "run/grid.png", "The grid, here.")

    def test_of_a_rendered_image_no_machine_is_named(self):
        self.assertIn("<summary>Rendered beforehand</summary>runs</details><div class=\"scroll card\" tabindex=0><a href=\"h100/closeup", self.page)

    def test_powers_in_captions(self):
        self.assertIn("After <span>2<sup>-6</sup></span> s.", self.page)

    def test_what_is_left_out_is_a_line_a_reason(self):
        self.assertIn("1 figure or table needs a GPU with OpenGL and CUDA: Main claims.", self.page)
        self.assertIn("1 figure or table needs measurements that this run lacks", self.page)

    def test_this_machines_answer_goes_before_the_recorded_one(self):
        there, here = reports()
        here.answer = ("Here.", "On this machine.")
        self.assertEqual(("Here.", "On this machine.", ["Equal: 12 sets."]), index.verdict([there, here]))

    def test_a_page_without_an_answer_says_so(self):
        there, here = reports()
        there.answer = ()
        self.assertIn("<h1>No run here compares OpenGL with CUDA on a GPU.</h1>", index.page_of([there, here]))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            self.assertEqual(self.page, index.write(folder, reports()).read_text())
            self.assertEqual(["Equal: 12 sets.", "No GPU was found.", f"OpenGL or CUDA: {' '.join(ANSWER)}"],
                             (folder / "verdict.txt").read_text().splitlines())
            for font in re.findall(r"url\((.*?)\)", index.STYLE):
                self.assertTrue((folder / font).exists(), font)

    def test_a_report_survives_its_file(self):
        there = reports()[0]
        self.assertEqual(there.text(), report.from_text(there.text()).text())

    def test_tables(self):
        made = as_html(Table("t", "", [[("", 1), ("OpenGL", 1)], ["n", "ms"]], [["10^6", "< 1"]]))
        self.assertIn("10<sup>6</sup>", made)
        self.assertIn("<td class=n>&lt; 1</td>", made)
        self.assertIn("<th colspan=1 class=g>OpenGL</th>", made)


class Answer(unittest.TestCase):
    @staticmethod
    def contests(n, ratios, p=0.0):
        return [Contest("all pairs", "triangle", n, 1, Ratio(middle, middle, middle, p, 5, frozenset("AB")), True, "", "step") for middle in ratios]

    def said(self, short, long, p=0.0):
        steps = (*self.contests(64, short), *self.contests(128, short)), self.contests(8192, long, p)
        with unittest.mock.patch.object(answer, "steps", lambda machine: [list(found) for found in steps]):
            return answer.answer(self.machine, True)

    @classmethod
    def setUpClass(cls):
        cls.machine = recorded_machine()

    def test_in_words(self):
        for short, long, words in (([2.4], [0.95, 1.05], "Short steps are faster in CUDA; long steps are about as fast in both."),
                                   ([0.8, 0.95], [0.7], "Steps are faster in OpenGL."), ([1.05], [1], "Steps are about as fast in both."),
                                   ([1.05, 2], [0.8, 1.2], "Short steps are faster in CUDA; long steps are faster in one or the "
                                    "other, depending on the work.")):
            self.assertEqual(words, self.said(short, long)[0])

    def test_with_ratios_and_gpu(self):
        self.assertRegex(self.said([2.4], [0.95, 1.05])[1],
                         r"^On the recorded NVIDIA H\w+ .*, OpenGL takes 2\.40x CUDA's time in steps of 64 to 128 spheres and 0\.95x to "
                         r"1\.05x in steps of 8,192 \(five processes on two GPUs\)\. In short steps the same GLSL through Vulkan takes "
                         r"1\.1x to 1\.2x the time of a CUDA graph of one step \(NVIDIA H200\)\.$")

    def test_what_is_undecided_is_no_difference(self):
        self.assertEqual("Short steps are faster in CUDA; long steps are about as fast in both.", self.said([2.4], [1.3], p=0.5)[0])

    def test_of_the_records(self):
        short, long = answer.steps(self.machine)
        self.assertLess(max(entry.n for entry in short), min(entry.n for entry in long))
        self.assertEqual({"step"}, {entry.table for entry in short})
        machine = recorded_machine()
        machine.records = [record for record in machine.records if record.parameters.get("n", 0) <= SHORT]
        self.assertRaises(Missing, answer.steps, machine)

    def test_software_answers_nothing(self):
        machine = recorded_machine("llvmpipe")
        self.assertRaises(Missing, answer.answer, machine, True)
        self.assertIn("No GPU was found", answer.why_not(machine))


class WithVulkan(unittest.TestCase):
    def test_a_machine_that_also_timed_vulkan_has_a_page(self):
        machine = recorded_machine("llvmpipe")
        machine.records += [replace(record, parameters={**record.parameters, "backend": "vulkan"})
                            for record in machine.records if record.parameters.get("backend") == "opengl"]
        opengl = next(backend for backend in machine.main["backends"] if backend["name"] == "opengl")
        machine.main = {**machine.main, "backends": [*machine.main["backends"], {**opengl, "name": "vulkan"}]}
        with tempfile.TemporaryDirectory() as folder, laid_out_alone():
            made = report.make(machine, pathlib.Path(folder), Progress())
        self.assertRegex(made.equal, "on CPU, OpenGL and Vulkan")
        self.assertTrue(any(line.startswith("Vulkan: ") for line in made.backends))
        self.assertIn("exactness", {item.name for item in made.items})


class Recorded(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name in ("paper/plots/scale.py", "paper/data/h100/results/1.json", "paper/data/other/results/1.json"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text("1")

    def digest(self):
        return recorded.digest(self.root / "paper/data/h100", self.root / "paper")

    def test_the_digest_follows_records_and_plots_alone(self):
        before = self.digest()
        (self.root / "paper/data/other/results/1.json").write_text("2")
        self.assertEqual(before, self.digest())
        for name in ("plots/scale.py", "data/h100/results/1.json"):
            (self.root / "paper" / name).write_text("2")
            self.assertNotEqual(before, before := self.digest())
        with unittest.mock.patch.object(recorded.sources, "current", lambda: {"measure": "0"}):
            self.assertNotEqual(before, self.digest())

    def test_figures_are_drawn_once(self):
        drawn, folder, kept = [], self.root / "paper/data/h100", self.root / "kept"

        def make(machine, to, progress):
            drawn.append(to)
            to.mkdir(parents=True)
            (to / "grid.png").write_text("drawn")
            return reports()[0]

        changes = {"Machine": lambda folder: None, "digest": lambda folder: f"digest{len(drawn) > 1}"}
        with unittest.mock.patch.multiple(recorded, **changes), unittest.mock.patch.object(recorded.report, "make", make):
            for run, count in ((1, 1), (2, 1)):
                self.assertEqual("GPU 100", recorded.taken(folder, self.root / str(run), Progress(stream=io.StringIO()), kept).device)
                self.assertEqual("drawn", (self.root / str(run) / "grid.png").read_text())
                self.assertEqual(count, len(drawn))
            drawn.append("as if anything had changed")
            recorded.taken(folder, self.root / "3", Progress(stream=io.StringIO()), kept)
        self.assertEqual(3, len(drawn))
        self.assertEqual(["h100-digestTrue"], [path.name for path in kept.iterdir()])


class Names(unittest.TestCase):
    def said(self, terminal):
        stream, log = io.StringIO(), io.StringIO()
        stream.isatty = lambda: terminal
        progress = Progress(log, stream)
        progress.start("grid")
        progress.start("scale")
        progress.end()
        self.assertRegex(log.getvalue(), r"^grid: \d+\.\d s\nscale: \d+\.\d s\n$")
        return stream.getvalue()

    def test_a_terminal_has_one_line_and_a_file_a_line_each(self):
        self.assertEqual(0, self.said(True).count("\n"))
        self.assertEqual("  grid\n  scale\n", self.said(False))


if __name__ == "__main__":
    unittest.main()
