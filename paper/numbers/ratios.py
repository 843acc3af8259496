# SPDX-License-Identifier: MIT
"""The ratio of two times, its interval, and the one rule that decides whether it is a difference.

A process gives one value: the median over its rounds of the ratios of turns that followed each other or, of times that
took no turns together, the ratio of its medians. The interval is the t-interval of the values' logarithms. Of one process
it is that of its rounds, and says nothing of other processes. A difference is stated if the interval excludes 1 after
Holm's correction over the comparisons that are shown together.
"""
import math
import statistics
from dataclasses import dataclass, replace

import numpy
from scipy import stats

from paper.records import steady
from paper.spread import CONFIDENCE, plain_mean, quantile

ENOUGH = 6  # rounds, for an interval of the median between order statistics of 95 %
WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
ONE_PROCESS = "‡"  # marks ratios of one process
LEGEND = (f"In brackets 95 \\% intervals; undecided: 1 is not excluded after Holm's correction over the table's ratios. {ONE_PROCESS}: "
          "one process, an interval over its rounds.")


@dataclass(frozen=True)
class Ratio:
    middle: float
    low: float  # of the interval of this ratio alone
    high: float
    p: float  # two-sided, of the ratio 1; within a family after Holm's correction
    processes: int
    gpus: frozenset = frozenset()
    plain: float = None  # by the plain means of the longest batches

    @property
    def decided(self):
        return self.p < 1 - CONFIDENCE

    @property
    def text(self):
        middle = f"{self.middle:.2f}x" if self.decided else "undecided"
        return f"{middle} [{self.low:.2f}, {self.high:.2f}]" + ONE_PROCESS * (self.processes == 1)


@dataclass(frozen=True)
class Run:
    """One process of a timing."""
    gpu: str
    median: float
    plain: float
    samples: list


def runs_of(record):
    """number of the process -> Run."""
    samples, found = record.parameters.get("samples_ms", [record.median]), {}
    for run in record.parameters.get("processes", ()):
        found[run["process"]] = Run(run["gpu"], run["median_ms"], run["plain_ms"], samples[:run["rounds"]])
        samples = samples[run["rounds"]:]
    return found or {0: Run(None, record.median, plain_mean(record.parameters), samples)}


def common(left, right):
    """Both runs of each process that timed both."""
    ours, theirs = runs_of(left), runs_of(right)
    return [(ours[k], theirs[k]) for k in ours if k in theirs] if left.source == right.source else []


def in_turns(left, right):
    """They took their turns right behind each other."""
    contest = left.parameters.get("contest")
    return contest is not None and contest == right.parameters.get("contest")


def by_rounds(ours, theirs):
    """The ratio in each round; none where one has rounds that the other lacks."""
    same = len(ours.samples) == len(theirs.samples)
    return [a / b for a, b in zip(ours.samples, theirs.samples)] if same else []


def values(left, right):
    """The ratio in each process that timed both."""
    rounds = [by_rounds(*runs) if in_turns(left, right) else [] for runs in common(left, right)]
    return [statistics.median(own) if own else ours.median / theirs.median
            for own, (ours, theirs) in zip(rounds, common(left, right))]


def log_mean(observed):
    """(mean of the logarithms, its squared standard error, degrees of freedom)."""
    logs = numpy.log(observed)
    return float(logs.mean()), float(logs.var(ddof=1)) / len(logs) if len(logs) > 1 else math.inf, max(1, len(logs) - 1)


def difference(left, right):
    """log_mean of left over right, for independent observations (Welch 1947)."""
    (ours, first, of_first), (theirs, second, of_second) = log_mean(left), log_mean(right)
    error = first + second
    freedom = error**2 / (first**2 / of_first + second**2 / of_second) if 0 < error < math.inf else 1
    return ours - theirs, error, freedom


def observed(record):
    """The medians of its processes; of one process its samples."""
    runs = list(runs_of(record).values())
    return [run.median for run in runs] if len(runs) > 1 else runs[0].samples


def estimate(left, right):
    """Of the logarithm of the ratio: (mean, squared standard error, degrees of freedom)."""
    runs, found = common(left, right), values(left, right)
    if len(found) > 1:
        return log_mean(found)
    rounds = by_rounds(*runs[0]) if runs and in_turns(left, right) else []
    if rounds:
        return log_mean(rounds)
    return difference(runs[0][0].samples, runs[0][1].samples) if runs else difference(observed(left), observed(right))


def time_ratio(left, right):
    """Left's time over right's, alone: without a correction."""
    found, runs = values(left, right), common(left, right)
    mean, squared, freedom = estimate(left, right)
    error = math.sqrt(squared)
    p = 2 * stats.t.sf(abs(mean) / error, freedom) if error else float(mean == 0)
    p = p if steady(left, right) else 1.0  # times of a busy machine decide nothing
    low, high = (math.exp(mean + sign * quantile(freedom) * error) if error < math.inf else limit
                 for sign, limit in ((-1, 0.0), (1, math.inf)))
    plain = [ours.plain / theirs.plain for ours, theirs in runs if ours.plain and theirs.plain]
    return Ratio(statistics.median(found) if found else left.median / right.median, low, high, float(p), max(1, len(found)),
                 frozenset(ours.gpu or theirs.gpu for ours, theirs in runs if ours.gpu or theirs.gpu), statistics.median(plain) if plain else None)


def holm(p_values):
    """Adjusted so that the probability of any wrong rejection among them is at most the level (Holm 1979)."""
    order = numpy.argsort(p_values)
    stepped = numpy.maximum.accumulate((len(order) - numpy.arange(len(order))) * numpy.asarray(p_values)[order])
    adjusted = numpy.empty(len(order))
    adjusted[order] = numpy.minimum(1, stepped)
    return adjusted.tolist()


def family(pairs):
    """The ratios of all pairs that are shown together, decided together."""
    if not pairs:
        return []
    alone = [time_ratio(*pair) for pair in pairs]
    return [replace(each, p=p) for each, p in zip(alone, holm([each.p for each in alone]))]


def texts(pairs):
    """Of a table's column: the ratio of each pair, "-" for None."""
    found = iter(family([pair for pair in pairs if pair]))
    return [next(found).text if pair else "-" for pair in pairs]


def counted(counts, one, more):
    least, most = (WORDS[bound] if bound < len(WORDS) else str(bound) for bound in (min(counts), max(counts)))
    return f"{least if least == most else f'{least} to {most}'} {one if max(counts) == 1 else more}"


def extent(ratios):
    """What comparisons that are stated together stand on, e.g. five processes on two GPUs."""
    return (f"{counted([each.processes for each in ratios], 'process', 'processes')} on "
            f"{counted([max(1, len(each.gpus)) for each in ratios], 'GPU', 'GPUs')}")
