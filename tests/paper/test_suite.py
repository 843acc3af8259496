# SPDX-License-Identifier: MIT
"""The recorded suite counts each test once, and is refused unless it is whole, of one commit and of every backend."""
import fnmatch
import pathlib
import sys
import tempfile
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from changed_records import recorded  # noqa: E402  (the path must be set first)
from paper import parts  # noqa: E402
from paper.numbers import prose_equality  # noqa: E402
from paper.numbers.suite import suite  # noqa: E402
from paper.records import Missing  # noqa: E402
from paper.tables import suite as suite_table  # noqa: E402

FAMILY = "Backends/StressCatalogue.Row1_RandomBits/"
FILES = {**{backend: [FAMILY + backend, f"Backends/Draw.Draws/{backend}"] for backend in parts.BACKENDS},
         "rest-1": ["Oracle.IsExact"], "rest-2": ["Numbers.AreRead", "Film.Ends"]}


def output(names, commit="c0ffee", pairs=100, verdicts=None):
    """What the tests print."""
    lines = [f"commit: {commit}", "date: 2026-01-01T00:00:00Z", "cpu: made up"]
    for name in names:
        lines.append(f"[ RUN      ] {name}")
        if name.startswith(FAMILY):
            lines.append(f"{name[len(FAMILY):]}: {pairs} pairs, 25 ties, 3 overlapping; by stage 100 float")
        lines.append({"FAILED": "[  FAILED  ] {}, where GetParam() = 3 (5 ms)", "SKIPPED": "[  SKIPPED ] {} (0 ms)"}.get(
            (verdicts or {}).get(name), "[       OK ] {} (5 ms)").format(name))
    return "\n".join([*lines, f"[==========] {len(names)} tests from 3 test suites ran. (9 ms total)", ""])


class Suites(unittest.TestCase):
    def machine(self, **changed):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        tests = pathlib.Path(folder.name, "tests")
        tests.mkdir()
        texts = {**{name: output(names) for name, names in FILES.items()},
                 **{name.replace("_", "-"): text for name, text in changed.items()}}
        for name, text in texts.items():
            if text is not None:
                (tests / f"{name}.txt").write_text(text)
        (tests / "contacts_long.txt").write_text("no part of the suite")
        return types.SimpleNamespace(name="made up", folder=tests.parent)

    def refused(self, why, **changed):
        with self.assertRaisesRegex(Missing, why):
            suite(self.machine(**changed))

    def test_each_name_counts_once_and_pairs_once_a_backend(self):
        found = {}
        twice = output([*FILES["rest-2"], "Oracle.IsExact"])  # as from shards that share the tests out otherwise
        prose_equality.tests(lambda key, text, source, how: found.update({key: text}), self.machine(rest_2=twice), [])
        self.assertEqual({"tests/passed": "9", "tests/pairs": "100", "tests/ties": "25"}, found)

    def test_the_table_has_a_row_a_backend(self):
        skips = output(FILES["opengl"], verdicts={"Backends/Draw.Draws/opengl": "SKIPPED"})
        table = suite_table.suite(self.machine(opengl=skips))
        self.assertEqual([["CPU", "2", "0", "100", "25"], ["OpenGL", "1", "1", "100", "25"], ["CUDA", "2", "0", "100", "25"],
                          ["none of the three", "3", "0", "-", "-"]], table.rows)
        self.assertIn("commit c0ffee, 2026-01-01", table.caption)

    def test_a_backend_in_place_of_another_is_refused(self):
        """As CUDA's tests stood in OpenGL's shard."""
        self.refused("Backends/Draw.Draws was not run with each backend", opengl=output(FILES["cuda"]))
        self.refused("was not run with each backend", cpu=output(FILES["cpu"][:1]))

    def test_an_output_that_is_absent_cut_off_or_older_is_refused(self):
        self.refused("tests/ holds", opengl=None)
        self.refused("tests/ holds", **{"1": output(FILES["cuda"])})
        self.refused("opengl.txt does not hold the result of each", opengl=output(FILES["opengl"]).replace("[       OK ]", "[  WAS OK  ]", 1))
        self.refused("opengl.txt does not hold the result of each", opengl="\n".join(output(FILES["opengl"]).splitlines()[:-1]))
        self.refused("opengl.txt names no commit", opengl=output(FILES["opengl"]).replace("commit: ", ""))
        self.refused("of 2 commits", rest_1=output(FILES["rest-1"], commit="decaf"))

    def test_a_failed_test_and_unequal_numbers_of_pairs_are_refused(self):
        self.refused("Film.Ends failed", rest_2=output(FILES["rest-2"], verdicts={"Film.Ends": "FAILED"}))
        self.refused("unequal numbers of adversarial pairs", cuda=output(FILES["cuda"], pairs=99))

    def test_the_recorded_names_are_in_one_part_each(self):
        filters = [part.words.removeprefix("--gtest_filter=") for part in parts.GPU if part.name.startswith("tests-")]
        for name in [name for names in FILES.values() for name in names]:
            runs = [text for text in dict.fromkeys(filters) if matches(name, text)]
            self.assertEqual(1, len(runs), name)
        self.assertEqual(2, filters.count(filters[-1]))  # in two halves

    def test_a_record_of_the_paper_is_whole_or_the_statement_is_absent(self):
        numbers = {}
        try:
            prose_equality.tests(lambda key, text, *_: numbers.update({key: text}), recorded(), [])
            self.assertEqual("29,781,250", numbers["tests/pairs"])  # ARTIFACT.md, claim 2
        except Missing:
            self.assertEqual({}, numbers)


def matches(name, text):
    """As GoogleTest does: one of the patterns ahead of a minus, and none behind it."""
    wanted, _, unwanted = text.partition("-")
    return (not wanted or any(fnmatch.fnmatchcase(name, one) for one in wanted.split(":"))) and not any(
        fnmatch.fnmatchcase(name, one) for one in unwanted.split(":") if one)


if __name__ == "__main__":
    unittest.main()
