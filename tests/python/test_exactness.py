# SPDX-License-Identifier: MIT
"""Decisions where rounding would change them: overlaps of 1e-6 to 1e-15 far from the origin, ties, tiny numbers."""

import itertools
import unittest
from fractions import Fraction

import numpy as np
from support import Case, every_backend, oracle, spherepair


class Lattices(Case):
    """Spheres on a lattice far from the origin that overlap, or miss each other, by a little."""

    @every_backend
    def test_overlaps_far_from_the_origin(self, context):
        for exponent, sign, far in itertools.product((6, 9, 12, 15), (-1, 1), (1e3, 1e6, 3e9)):
            spacing = 1.1
            points = far + spacing * np.array(list(itertools.product(range(3), repeat=3)))
            radii = np.full(27, spacing / 2 * (1 + sign * 10.0**-exponent))
            with self.subTest(exponent=exponent, sign=sign, far=far):
                self.check_list(context, points, None, radii=radii, half=True)

    @every_backend
    def test_one_pair_in_fractions(self, context):
        """The rule itself, with no help from the oracle's scaling."""
        random = np.random.default_rng(1)
        decided = set()
        for exponent in (6, 9, 12, 15):
            for _ in range(20):
                a = random.uniform(-1e6, 1e6, 3)
                b = a + random.uniform(-1, 1, 3)
                square = sum((Fraction(q) - Fraction(p))**2 for p, q in zip(a.tolist(), b.tolist()))
                reach = float(square)**0.5 * (1 + float(random.choice([-1, 0, 1])) * 10.0**-exponent)
                radii = [reach * 0.3, reach - reach * 0.3]
                expected = square < (Fraction(radii[0]) + Fraction(radii[1]))**2
                found = len(spherepair.collisions([a, b], radii, backend=context))
                self.assertEqual(expected, bool(found), (a, b, radii))
                decided.add(expected)
        self.assertEqual({True, False}, decided)

    @every_backend
    def test_images_far_from_the_origin(self, context):
        for exponent, far in itertools.product((9, 12, 15), (1e4, 1e8)):
            cell = np.diag([3.3, 3.3, 3.3])
            points = far + 1.1 * np.array(list(itertools.product(range(2), repeat=3)))
            for cutoff in (2.2 * (1 - 10.0**-exponent), 2.2 * (1 + 10.0**-exponent)):
                with self.subTest(exponent=exponent, far=far, cutoff=cutoff):
                    self.check_list(context, points, cutoff, cell)


class Ties(Case):
    @every_backend
    def test_touching_spheres(self, context):
        """Squares of 3, 4, 5 and of their like have no rounding: the sign of the comparison alone decides."""
        points = [[0, 0, 0], [3, 4, 0], [2, 3, 6], [0, -5, 0], [1, 4, 8]]
        for cutoff, touching in ((5, 2), (7, 1), (9, 1)):
            strict = len(self.check_list(context, points, cutoff, half=True))
            self.assertEqual(strict + touching, len(self.check_list(context, points, cutoff, half=True, inclusive=True)))

    @every_backend
    def test_a_sum_of_radii_is_not_rounded(self, context):
        """0.1 + 0.2 is below the float64 0.30000000000000004 that a rounded sum would be."""
        self.assertGreater(0.1 + 0.2, Fraction(0.1) + Fraction(0.2))
        points = [[0, 0, 0], [0.1 + 0.2, 0, 0]]
        self.assertEqual(0, len(spherepair.neighbor_list("i", points, radii=[0.1, 0.2], inclusive=True, backend=context)))
        self.assertEqual(2, len(spherepair.neighbor_list("i", points, 0.1 + 0.2, inclusive=True, backend=context)))

    @every_backend
    def test_a_skin_is_not_rounded(self, context):
        points = [[0, 0, 0], [1 + 2.0**-52, 0, 0]]
        for skin, expected in ((2.0**-53, 0), (2.0**-52, 0), (2.0**-52 + 2.0**-80, 1)):
            self.assertEqual(expected, len(self.check_list(context, points, 1.0, skin=skin, half=True)))

    @every_backend
    def test_vectors_are_correctly_rounded(self, context):
        """Differences that cancel: float64 arithmetic in any order would round twice."""
        random = np.random.default_rng(2)
        cell = np.array([[1 / 3, 1e-9, 0], [0.1, 1 / 7, 1e-17], [1e-12, 0.3, 0.7]])
        points = random.uniform(-1, 1, (6, 3)) * 10.0**random.integers(-3, 3, (6, 1))
        self.assertGreater(self.check_geometry(context, points, 0.4, cell), 50)


class Sizes(Case):
    @every_backend
    def test_tiny_and_large_units(self, context):
        """A change of unit by a power of two changes no list."""
        points = np.random.default_rng(3).uniform(0, 2, (12, 3))
        expected = self.check_list(context, points, 0.8, np.diag([2.0] * 3))
        for power in (-300, -100, 100, 300):
            unit = 2.0**power
            self.assertEqual(expected, self.listed(context, points * unit, 0.8 * unit, np.diag([2.0 * unit] * 3)), power)

    @every_backend
    def test_tiny_distances_beside_large_ones(self, context):
        points = [[0, 0, 0], [1e-30, 0, 0], [1e12, 0, 0], [1e12, 1e-30, 0], [1.5e-30, 1e-31, 0]]
        self.assertEqual(4, len(self.check_list(context, points, 1e-29, half=True)))
        self.check_list(context, points, 1e-30, half=True)
        self.check_list(context, points, 1e12, half=True, inclusive=True)

    @every_backend
    def test_float32_is_widened_not_rounded(self, context):
        """float32 positions with a cutoff that float32 does not have."""
        points = np.array([[0, 0, 0], [0.1, 0, 0]], np.float32)
        cutoff = float(np.float32(0.1))
        self.assertEqual(oracle(points, 0.1), self.listed(context, points, 0.1))
        self.assertEqual([0, 2], [len(self.listed(context, points, c)) for c in (cutoff, np.nextafter(cutoff, 1))])


if __name__ == "__main__":
    unittest.main()
