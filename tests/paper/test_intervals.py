# SPDX-License-Identifier: MIT
"""Intervals cover what they are about, and Holm's correction holds the error of a family: by simulated processes whose
times are known. Needs no matplotlib and no LaTeX."""
import math
import pathlib
import random
import statistics
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))

from paper import spread  # noqa: E402  (the path must be set first)
from paper.numbers import ratios  # noqa: E402
from paper.records import Record  # noqa: E402

TRIALS = 600
ROUNDS = 11
BETWEEN, WITHIN = 0.02, 0.005  # standard deviations of the logarithms: of processes, and of rounds of one
ERROR = 3.5  # standard errors of a share that a simulation may be off


def process(rng, ratio, between):
    """The samples of both contenders in one process, whose ratio is off by the process's own factor."""
    own = ratio * math.exp(rng.gauss(0, between))
    cuda = [math.exp(rng.gauss(0, WITHIN)) for _ in range(ROUNDS)]
    return [own * time * math.exp(rng.gauss(0, WITHIN)) for time in cuda], cuda


def recorded(rng, ratio, processes, between=BETWEEN):
    """The records of OpenGL and CUDA, merged as the paper merges those of several processes."""
    roots = []
    for made in (process(rng, ratio, between) for _ in range(processes)):
        rows = [{"backend": backend, "contest": "simulated", "n": 64, "scene": {}, "samples_ms": samples}
                for backend, samples in zip(("opengl", "cuda"), made)]
        roots.append({"measurements": rows, "backends": []})
    return [Record(row, *spread.summary(row), "simulated") for row in spread.merged(roots)["measurements"]]


def ranges(left, right):
    """The interval that the paper had before: the widest of the layers within and between processes, with every process's ratio."""
    medians = ratios.values(left, right)
    within = [[end / median for end in spread.median_interval(ratios.by_rounds(*runs))]
              for median, runs in zip(medians, ratios.common(left, right))]
    middle = statistics.median(medians)
    layers = [[statistics.median(ends) for ends in zip(*within)], [end / middle for end in spread.median_interval(medians)]]
    low, high = max(layers, key=lambda ends: ends[1] - ends[0])
    return min(low * middle, *medians), max(high * middle, *medians)


def intervals_of_this_paper(left, right):
    found = ratios.time_ratio(left, right)
    return found.low, found.high


class Coverage(unittest.TestCase):
    def covered(self, interval, processes, ratio=1.2):
        """Share of trials whose interval holds the ratio, and its standard error if it is 95 %."""
        rng, hits = random.Random(processes), 0
        for _ in range(TRIALS):
            low, high = interval(*recorded(rng, ratio, processes))
            hits += low <= ratio <= high
        return hits / TRIALS, math.sqrt(0.95 * 0.05 / TRIALS)

    def test_over_three_and_five_processes_it_is_95_percent(self):
        for processes in (3, 5):
            share, error = self.covered(intervals_of_this_paper, processes)
            self.assertAlmostEqual(0.95, share, delta=ERROR * error, msg=f"{processes} processes")

    def test_of_a_time_too(self):
        rng, hits = random.Random(1), 0
        for _ in range(TRIALS):
            glsl, _ = recorded(rng, 1.2, 5)
            hits += glsl.low <= 1.2 <= glsl.high
        self.assertAlmostEqual(0.95, hits / TRIALS, delta=ERROR * math.sqrt(0.95 * 0.05 / TRIALS))

    def test_the_range_of_the_processes_did_not(self):
        for processes, expected in ((3, 0.75), (5, 0.94)):
            share, error = self.covered(ranges, processes)
            self.assertAlmostEqual(expected, share, delta=ERROR * error + 0.02, msg=f"{processes} processes")

    def test_rounds_of_one_process_do_not_cover_others(self):
        self.assertLess(self.covered(intervals_of_this_paper, 1)[0], 0.4)

    def test_of_one_process_rounds_cover_its_own_ratio(self):
        rng, hits = random.Random(7), 0
        for _ in range(TRIALS):
            found = ratios.time_ratio(*recorded(rng, 1.2, 1, between=0))
            hits += found.low <= 1.2 <= found.high
        self.assertAlmostEqual(0.95, hits / TRIALS, delta=ERROR * math.sqrt(0.95 * 0.05 / TRIALS))


class Families(unittest.TestCase):
    """Twenty contests without any difference: how often one is stated."""

    def wrong(self, decided, families=80, contests=20):
        rng = random.Random(3)
        return sum(any(each.decided for each in decided([recorded(rng, 1, 5) for _ in range(contests)]))
                   for _ in range(families)) / families

    def test_holm_holds_the_error_of_the_family(self):
        self.assertLessEqual(self.wrong(ratios.family), 0.05 + ERROR * math.sqrt(0.05 * 0.95 / 80))

    def test_without_it_a_family_errs(self):
        self.assertGreater(self.wrong(lambda pairs: [ratios.time_ratio(*pair) for pair in pairs]), 0.4)

    def test_steps(self):
        self.assertEqual([0.04, 0.06, 0.06, 0.06],
                         [round(p, 9) for p in ratios.holm([0.01, 0.03, 0.02, 0.04])])
        self.assertEqual([1, 1], ratios.holm([0.6, 0.9]))

    def test_a_large_difference_survives(self):
        rng = random.Random(4)
        found = ratios.family([recorded(rng, 1.2, 5)] + [recorded(rng, 1, 5) for _ in range(19)])
        self.assertTrue(found[0].decided)
        self.assertFalse(any(each.decided for each in found[1:]))


class OrderStatistics(unittest.TestCase):
    def test_the_interval_of_eleven_rounds_leaves_out_one_on_each_side(self):
        self.assertEqual((2, 10), spread.median_interval(range(1, 12)))
        self.assertEqual((1, 6), spread.median_interval(range(1, 7)))  # 96.9 %
        self.assertEqual((1, 3), spread.median_interval([1, 2, 3]))  # the whole range covers 75 %

    def test_its_coverage_is_what_is_left_of_the_binomial(self):
        for count in range(6, 60):
            out = spread.left_out(count)
            tails = [2 * sum(math.comb(count, k) for k in range(last + 1)) / 2**count for last in (out, out + 1)]
            self.assertLessEqual(tails[0], 0.05)
            self.assertGreater(tails[1], 0.05)


if __name__ == "__main__":
    unittest.main()
