# SPDX-License-Identifier: MIT
"""What OpenGL's extensions are worth: table and sentence follow the records."""
import pathlib
import sys
import unittest

sys.path[:0] = map(str, (pathlib.Path(__file__).resolve().parents[2], pathlib.Path(__file__).resolve().parent))

from changed_records import changed, recorded  # noqa: E402  (the path must be set first)
from paper import headline  # noqa: E402
from paper.numbers import contests, extensions  # noqa: E402
from paper.records import Missing  # noqa: E402
from paper.tables.extensions import extensions as table  # noqa: E402

CORE = {"backend": "opengl-core", "n": 10**7, "order": "cold"}


class Extensions(unittest.TestCase):
    def test_the_table_has_each_work_and_each_extension(self):
        made = table(recorded())
        self.assertLessEqual({"grid, random order", "grid, cell order", "move, anchored"}, {row[0] for row in made.rows})
        self.assertLessEqual({f"without {name}" for name in extensions.NAMED.values()}, {row[0] for row in made.rows})

    def test_table_and_sentence_follow_the_records(self):
        slower = changed(lambda record: record.matches(CORE), lambda _: 2)
        row = next(row for row in table(slower).rows if row[:2] == ["grid, random order", "10,000,000"])
        self.assertRegex(row[5], r"^2\.\d\dx")
        self.assertRegex(headline.extensions(slower), r"to 2\.\d\dx as long, .*longest: grid, random order")

    def test_without_its_records_there_is_none(self):
        machine = recorded()
        machine.records = [record for record in machine.records if not record.table.startswith("core_")]
        with self.assertRaises(Missing):
            table(machine)

    def test_these_records_are_no_contests_of_the_apis(self):
        self.assertNotIn("core_grid", {entry.table for entry in contests.contests(recorded())})


if __name__ == "__main__":
    unittest.main()
