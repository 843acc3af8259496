# SPDX-License-Identifier: MIT
"""What the tests of the Python package share: backends that open, an oracle in rational arithmetic, comparisons.

SPHEREPAIR_LIBRARY is the path of libspherepair.so. REQUIRE_BACKENDS=cpu,cuda makes a missing backend a failure.
"""

import functools
import itertools
import math
import os
import pathlib
import pickle
import sys
import unittest
from fractions import Fraction

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

import spherepair  # noqa: E402

MISSING = spherepair.backends()
REQUIRED = [name.strip() for name in os.environ.get("REQUIRE_BACKENDS", "").split(",") if name.strip()]
CONTEXTS = {name: spherepair.open(name) for name, reason in MISSING.items() if reason is None}
for _name in REQUIRED:
    if _name not in CONTEXTS:
        raise RuntimeError(f"REQUIRE_BACKENDS names {_name}: {MISSING.get(_name, 'there is no such backend')}")


def every_backend(test):
    """Runs a test once with the context of each backend that opens."""
    @functools.wraps(test)
    def run(self):
        for name, context in CONTEXTS.items():
            with self.subTest(backend=name):
                test(self, context)
    return run


def on_a_grid(values):
    """Python integers for floats, all with one power of two as their unit. Returns them and the unit's inverse."""
    fractions = [Fraction(float(value)) for value in values]
    scale = max((fraction.denominator for fraction in fractions), default=1)
    return [int(fraction * scale) for fraction in fractions], scale


def shift_ranges(positions, cell, pbc, reach):
    """For each pair of points the shifts that may come within reach, one range an axis: a few too many."""
    axes = [k for k in range(3) if cell is not None and pbc[k]]
    dual = np.zeros((3, 3))
    if axes:
        dual[axes] = np.linalg.pinv(np.asarray(cell, float)[axes]).T
    fractional = np.asarray(positions, float).reshape(-1, 3) @ dual.T
    width = reach * np.linalg.norm(dual, axis=1)

    def ranges(i, j):
        away = fractional[j] - fractional[i]
        return [range(math.ceil(-away[k] - width[k] - 0.01), math.floor(-away[k] + width[k] + 0.01) + 1) if k in axes
                else (0,) for k in range(3)]
    return ranges


def remembered(function):
    """Calls the function once for equal arguments: each backend is checked against the same rows."""
    known = {}

    @functools.wraps(function)
    def call(*arguments, **options):
        key = pickle.dumps((arguments, options))
        if key not in known:
            known[key] = function(*arguments, **options)
        return known[key]
    return call


@remembered
def oracle(positions, cutoff=0.0, cell=None, pbc=(True, True, True), radii=None, skin=0.0, half=False, inclusive=False,
           self_pairs=False, systems=None, exclude=(), queries=None, query_radii=None):
    """The list by its definition, in integers: sorted rows (i, j, S0, S1, S2) of one box."""
    points = np.asarray(positions, float).reshape(-1, 3)
    firsts = points if queries is None else np.asarray(queries, float).reshape(-1, 3)
    cell = np.diag(cell) if np.shape(cell) == (3,) else cell
    box = np.zeros((3, 3)) if cell is None else np.where(np.asarray(pbc, bool)[:, None], cell, 0.0)
    sizes = [cutoff] * len(points) if radii is None else list(radii)
    first_sizes = [0.0] * len(firsts) if radii is None else list(radii if queries is None else query_radii)
    lengths = len(points) + len(firsts)
    whole, _ = on_a_grid([*points.flat, *firsts.flat, *box.flat, *sizes, *first_sizes, skin])
    x, whole = whole[:3 * len(points)], whole[3 * len(points):]
    y, whole = whole[:3 * len(firsts)], whole[3 * len(firsts):]
    h, reach = whole[:9], whole[9:]
    longest = max(sizes, default=0) + max(first_sizes, default=0) + skin
    ranges = shift_ranges(np.concatenate((firsts, points)), cell, pbc, longest)
    excluded = {tuple(pair) for pair in exclude} | ({tuple(pair)[::-1] for pair in exclude} if queries is None else set())
    rows = []
    for i, j in itertools.product(range(len(firsts)), range(len(points))):
        if (i, j) in excluded or systems is not None and systems[i] != systems[j]:
            continue
        c = reach[j] + reach[len(points) + i] + reach[lengths]
        for shift in itertools.product(*ranges(i, len(firsts) + j)):
            if queries is None and i == j and not any(shift) and not self_pairs:
                continue
            if half and (i > j or i == j and shift < (0, 0, 0)):
                continue
            square = sum((x[3 * j + k] - y[3 * i + k] + sum(shift[m] * h[3 * m + k] for m in range(3)))**2
                         for k in range(3))
            if square < c * c or inclusive and square == c * c:
                rows.append((i, j, *shift))
    return sorted(rows)


def rows_of(i, j, shifts):
    """A list as sorted rows would be: tuples in the order of the list."""
    return [(*pair, *shift) for pair, shift in zip(zip(i.tolist(), j.tolist()), shifts.tolist())]


class Case(unittest.TestCase):
    """Checks lists against the oracle, and their vectors and distances against rational numbers."""

    def listed(self, context, positions, cutoff=None, cell=None, pbc=None, **options):
        i, j, shifts = spherepair.neighbor_list("ijS", positions, cutoff, cell, pbc, backend=context, **options)
        return rows_of(i, j, shifts)

    def check_list(self, context, positions, cutoff=None, cell=None, pbc=None, **options):
        """The library's list, after it is found equal to the oracle's."""
        found = self.listed(context, positions, cutoff, cell, pbc, **options)
        if "batch" in options:
            options["systems"] = options.pop("batch")
        expected = oracle(positions, cutoff or 0.0, cell, (True, True, True) if pbc is None else pbc, **options)
        self.assertEqual(expected, found)
        return found

    def check_geometry(self, context, positions, cutoff, cell=None, pbc=None, **options):
        """D is the float64 next to the real vector, d at most 2 units in the last place from its length."""
        i, j, shifts, distances, vectors = spherepair.neighbor_list("ijSdD", positions, cutoff, cell, pbc,
                                                                    backend=context, **options)
        box = np.zeros((3, 3)) if cell is None else np.asarray(cell, float)
        for row in range(len(i)):
            exact = [Fraction(float(positions[j[row]][k])) - Fraction(float(positions[i[row]][k]))
                     + sum(int(shifts[row, m]) * Fraction(float(box[m, k])) for m in range(3) if shifts[row, m])
                     for k in range(3)]
            self.assertEqual([float(component) for component in exact], vectors[row].tolist())
            square, d = sum(component**2 for component in exact), float(distances[row])
            margin = 2 * Fraction(math.ulp(d))
            self.assertLessEqual(max(Fraction(d) - margin, 0)**2, square)
            self.assertGreaterEqual((Fraction(d) + margin)**2, square)
        return len(i)
