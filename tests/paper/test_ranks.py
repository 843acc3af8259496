# SPDX-License-Identifier: MIT
"""What two times are said to show, in records of contests and in those from before. Needs no matplotlib and no LaTeX."""
import pathlib
import statistics
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper.numbers import derived, ranks  # noqa: E402  (the path must be set first)
from paper.records import Record, median_interval  # noqa: E402


class Ranks(unittest.TestCase):
    def test_apart_and_alike(self):
        low, high = list(range(11)), list(range(20, 31))
        self.assertAlmostEqual(2 / 705432, ranks.rank_test(low, high))
        self.assertEqual(1.0, ranks.rank_test(low, low))
        self.assertAlmostEqual(0.2, ranks.rank_test([1, 2, 4], [3, 5, 6]))

    @staticmethod
    def record(samples, **parameters):
        low, high = median_interval(samples)
        parameters = {"samples_ms": samples, **parameters}
        return Record(parameters, statistics.median(samples), low, high, "machine:1")

    # The load doubles both times in some rounds, so that the intervals of the medians overlap.
    def test_turns_of_a_contest_are_compared_round_by_round(self):
        cuda = [1, 2, 1, 2, 1, 2, 1, 2, 1, 2, 1]
        glsl = [1.1 * time for time in cuda]
        alone = [self.record(samples) for samples in (glsl, cuda)]
        contest = [self.record(samples, contest="collide_tiled 128") for samples in (glsl, cuda)]
        self.assertEqual("no difference seen", ranks.verdict(*alone))
        self.assertEqual("CUDA 9.1 % faster", ranks.verdict(*contest))
        self.assertTrue(ranks.apart(*contest))
        for value, expected in zip(derived.ratio(*contest), (1.1, 0, 0)):
            self.assertAlmostEqual(expected, value)
        other = self.record(cuda, contest="collide_square 128")
        self.assertFalse(ranks.apart(contest[0], other))

    def test_a_stage_at_the_timers_floor_is_no_comparison(self):
        stages = {"device_stages_ms": {"clear": 4e-3}, "device_stages_interval_ms": {"clear": [4e-3, 5e-3]}, "n": 64}
        glsl, cuda = (self.record([1.0], **stages) for _ in range(2))
        self.assertIsNotNone(derived.stage_ratio("clear", glsl, cuda))
        marked = self.record([1.0], device_stages_at_floor=["clear"], **stages)
        self.assertIsNone(derived.stage_ratio("clear", glsl, marked))


if __name__ == "__main__":
    unittest.main()
