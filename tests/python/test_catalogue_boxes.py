# SPDX-License-Identifier: MIT
"""Reports of users of other neighbour lists, by their numbers in the catalogue: boxes and images."""

import itertools
import unittest

import numpy as np
from support import CONTEXTS, Case, every_backend, oracle, rows_of, spherepair

SLAB = (True, True, False)
OPEN = (False, False, False)


class Boxes(Case):
    @every_backend
    def test_01_zero_row_along_an_open_axis(self, context):
        """Luthaf/vesin#153"""
        cell = [[8, 0, 0], [0, 9, 0], [0, 0, 0]]
        points = [[0, 5, 0], [4, 0, 0]]
        for inclusive in (False, True):
            self.assertEqual(40, len(self.check_list(context, points, 15, cell, SLAB, inclusive=inclusive)))
            self.assertEqual(20, len(self.check_list(context, points, 15, cell, SLAB, inclusive=inclusive, half=True)))

    @every_backend
    def test_02_triclinic_boxes(self, context):
        """Luthaf/vesin#157"""
        random = np.random.default_rng(2)
        for _ in range(4):
            cell = np.diag(random.uniform(3, 9, 3)) + np.tril(random.uniform(-4, 4, (3, 3)), -1)
            self.assertGreater(len(self.check_list(context, random.uniform(-5, 5, (6, 3)), 5.0, cell)), 20)

    @every_backend
    def test_03_negative_coordinates_and_translations(self, context):
        """Luthaf/vesin, CHANGELOG 0.5.8"""
        points = np.random.default_rng(3).integers(-4096, 0, (40, 3)) / 1024
        turned = np.array([[0, 4.0, 0], [-4.0, 0, 0], [0, 0, 4.0]])
        for pbc in (OPEN, SLAB, (False, True, True)):
            first = self.check_list(context, points, 1.25, turned, pbc)
            self.assertGreater(len(first), 20)
            for by in (-1024.0, 2.0, 1048576.0):
                self.assertEqual(first, self.listed(context, points + by, 1.25, turned, pbc))

    @every_backend
    def test_05_no_entry_twice_in_a_small_cell(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#3"""
        found = self.check_list(context, [[3, 0, 0.5], [1, 0, 3.5]], 2.5, [4, 9, 4])
        self.assertEqual([(0, 1, 0, 0, -1), (0, 1, 1, 0, -1), (1, 0, -1, 0, 1), (1, 0, 0, 0, 1)], found)

    @every_backend
    def test_07_the_cell_does_not_matter_along_open_axes(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#104"""
        water = [[0, 0, 0.119], [0, 0.763, -0.477], [0, -0.763, -0.477]]
        expected = self.listed(context, water, 1.2)
        self.assertEqual(4, len(expected))
        self.assertEqual(expected, self.listed(context, water, 1.2, np.eye(3), OPEN))
        across = [[0.5, 0.5, -0.25], [0.5, 0.5, 0.25]]
        for height in (1.0, 100.0):
            self.assertEqual([(0, 1, 0, 0, 0)], self.listed(context, across, 0.75, [4, 4, height], SLAB, half=True))

    @every_backend
    def test_08_wrapped_and_unwrapped(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#18"""
        random = np.random.default_rng(8)
        cell, wrapped = np.array([[8.0, 0, 0], [2, 8, 0], [-1, 3, 8]]), random.integers(0, 4096, (30, 3)) / 512
        moved = random.integers(-3, 4, (30, 3))
        unwrapped = wrapped + moved @ cell
        i, j, shifts, vectors = spherepair.neighbor_list("ijSD", wrapped, 3.0, cell, backend=context)
        back = sorted(rows_of(i, j, shifts + moved[i] - moved[j]))
        self.assertEqual(back, self.check_list(context, unwrapped, 3.0, cell))
        np.testing.assert_array_equal(wrapped[j] - wrapped[i] + shifts @ cell, vectors)

    @every_backend
    def test_09_a_cell_that_is_huge_against_the_cutoff(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#120"""
        points = [[0.001, 5, 5], [999999.999, 5, 5], [5e5, 5e5, 5e5], [5e5, 5e5, 5e5 + 0.009]]
        found = self.check_list(context, points, 0.01, [1e6, 1e6, 1e6])
        self.assertEqual([(0, 1, -1, 0, 0), (1, 0, 1, 0, 0), (2, 3, 0, 0, 0), (3, 2, 0, 0, 0)], found)

    @every_backend
    def test_16_left_handed_cells(self, context):
        """facebookresearch/fairchem#2134"""
        points = np.random.default_rng(16).uniform(0, 3, (12, 3))
        right = self.check_list(context, points, 2.0, np.diag([3.0, 3, 3]))
        left = self.check_list(context, points, 2.0, np.diag([3.0, 3, -3]))
        self.assertEqual(right, sorted((i, j, a, b, -c) for i, j, a, b, c in left))

    @every_backend
    def test_23_a_lattice_in_a_periodic_box(self, context):
        """NVIDIA/warp#283"""
        line = 0.05 + 0.1 * np.arange(10)
        points = np.array(list(itertools.product(line, line, line)))
        offsets, _ = spherepair.csr(points, 0.18, [1, 1, 1], backend=context)
        self.assertEqual({26}, set(np.diff(offsets).tolist()))

    @every_backend
    def test_26_a_slab_of_silver(self, context):
        """MDAnalysis/mdanalysis#2345"""
        side = 4.09 / np.sqrt(2)
        a, b = np.array([side, 0, 0]), np.array([side / 2, side * np.sqrt(0.75), 0])
        points = [p * a + q * b + layer * ((a + b) / 3 + [0, 0, 4.09 / np.sqrt(3)])
                  for layer in range(4) for p in range(5) for q in range(5)]
        for cutoff, pbc in itertools.product((2.9, 3.2), (SLAB, (True, True, True))):
            i = spherepair.neighbor_list("i", points, cutoff, [5 * a, 5 * b, [0, 0, 30.0]], pbc, backend=context)
            self.assertEqual([0] * 9 + [50, 0, 0, 50], np.bincount(np.bincount(i)).tolist())

    @every_backend
    def test_28_small_and_tilted_boxes(self, context):
        """MDAnalysis/mdanalysis#2670, yesint/molar#6"""
        tilted = np.array([[10.0, 0, 0], [4, 10, 0], [-4, 0, 10]])
        points = [[38.9214, 40.0078, -34.0795], [-26.6187, 40.8926, 30.9709]]
        i, j, shifts, d = spherepair.neighbor_list("ijSd", points, 5.36, tilted, half=True, backend=context)
        self.assertEqual([(0, 1, 4, 0, -6)], rows_of(i, j, shifts))
        self.assertAlmostEqual(5.353627, d[0], 6)
        sixty = 0.01 * np.array([[1, 0, 0], [0.5, np.sqrt(0.75), 0], [0.5, np.sqrt(1 / 12), np.sqrt(2 / 3)]])
        self.assertGreater(len(self.check_list(context, [[0, 0, 0], [51.3, -17.0, 4.0]], 0.0125, sixty)), 40)

    @every_backend
    def test_30_tilts_of_half_a_width(self, context):
        """lammps/lammps#2759, #3846"""
        tilt = np.array([[10.0, 0, 0], [5, 10, 0], [0, 0, 10]])
        points = [[-0.5, -0.25, 3], [10.25, 10.5, 3.5]]
        lists = []
        for change in (-1e-15, 0, 1e-15):
            cell = tilt + np.array([[0, 0, 0], [change, 0, 0], [0, 0, 0]])
            lists.append(self.check_list(context, points, 5.0, cell, half=True))
        self.assertEqual([1, 1, 1], [len(found) for found in lists])
        self.assertEqual([lists[0]] * 2, lists[1:])

    @every_backend
    def test_31_diamond_in_repeated_cells(self, context):
        """zerothi/sisl#1016"""
        cell = 3.567 * np.diag([np.sqrt(0.5), np.sqrt(0.5), 1])
        basis = np.array([[0, 0, 0], [0.5, 0.5, 0.5], [0, 0.5, 0.25], [0.5, 0, 0.75]]) @ cell
        for repeats, expected in (((1, 1, 1), 112), ((1, 2, 1), 224), ((2, 2, 1), 448), ((1, 7, 1), 784)):
            points = [atom + np.array(k) @ cell for k in itertools.product(*map(range, repeats)) for atom in basis]
            i = spherepair.neighbor_list("i", points, 3.0, cell * np.array(repeats)[:, None], backend=context)
            self.assertEqual(expected, len(i), repeats)

    @every_backend
    def test_32_hcp_and_hcp_moved(self, context):
        """lmhale99/atomman#12"""
        cell = np.array([[1, 0, 0], [-0.5, np.sqrt(0.75), 0], [0, 0, np.sqrt(8 / 3)]]) * 3.2
        basis = np.array([[1 / 3, 2 / 3, 0.25], [2 / 3, 1 / 3, 0.75]]) @ cell
        points = np.array([atom + np.array(k) @ cell for k in itertools.product(range(3), repeat=3) for atom in basis])
        for moved in (points, points + 1.0):
            offsets, _ = spherepair.csr(moved, 3.3, 3 * cell, backend=context)
            self.assertEqual([12] * 54, np.diff(offsets).tolist())

    @every_backend
    def test_33_a_box_slightly_under_nine_cutoffs(self, context):
        """brucefan1983/GPUMD#190"""
        random = np.random.default_rng(33)
        points = random.uniform(0, 80.9, (120, 3))
        points[:30, 0] = random.choice([0.0, 1e-9, 80.9, 80.9 - 1e-9], 30)
        self.assertGreater(len(self.check_list(context, points, 9.0, [80.9] * 3)), 40)

    @every_backend
    def test_34_coordinates_that_round_onto_an_edge(self, context):
        """lab-cosmo/librascal#310"""
        points = [[1.999999999998 - 1, 0, 0], [1.999999999998, 0, 0], [-1e-17, 0, 0], [2.0, 0, 0], [0.25, 0, 0]]
        for cell in ([2, 2, 2], [1, 1, 1]):
            self.assertTrue(self.check_list(context, points, 0.5, cell))

    @every_backend
    def test_35_cells_of_large_numbers(self, context):
        """libAtoms/matscipy#5"""
        for signs in itertools.permutations([-8617.0, 8621.0, 8621.0]):
            cell = np.array([np.roll(signs, k) for k in range(3)])
            self.assertEqual(8, len(self.check_list(context, [[0, 0, 0]], 15000.0, cell)))
            self.assertEqual([], self.listed(context, [[0, 0, 0]], 5.0, cell))

    @every_backend
    def test_36_a_dimer_without_a_cell(self, context):
        """libAtoms/matscipy#7"""
        found = self.listed(context, [[0, 0, 0], [2.5, 0, 0]], 3, np.zeros((3, 3)), OPEN, half=True)
        self.assertEqual([(0, 1, 0, 0, 0)], found)

    @every_backend
    def test_48_points_outside_and_on_a_face(self, context):
        """glotzerlab/freud#582, #235"""
        side = 2 * np.sqrt(0.5)
        points = np.array([[side / 2, 0, 0], [-side / 2, 0, 0], [0.1, 0.2, 0.3], [7.5, -9.25, 3.125]])
        self.assertTrue(self.check_list(context, points, 0.9, [side] * 3))

    def test_21_backends_agree(self):
        """rusty1s/pytorch_cluster#96"""
        if len(CONTEXTS) < 2:
            self.skipTest(f"only {', '.join(CONTEXTS)} opens here")
        points = np.random.default_rng(21).uniform(0, 4, (3000, 3)).astype(np.float32)
        lists = {name: spherepair.neighbor_list("ijSdD", points, 0.4, [[4, 0, 0], [1, 4, 0], [0, 1, 4]], backend=context)
                 for name, context in CONTEXTS.items()}
        for name, found in lists.items():
            for ours, theirs in zip(lists["cpu"], found):
                self.assertEqual(ours.tobytes(), theirs.tobytes(), name)


class Oracle(unittest.TestCase):
    def test_it_counts_what_is_known(self):
        """The oracle itself, on a simple cubic lattice of one point."""
        for cutoff, expected in ((1.0, 0), (1.1, 6), (1.5, 18), (1.8, 26)):
            self.assertEqual(expected, len(oracle([[0.5, 0.5, 0.5]], cutoff, np.eye(3))))
        self.assertEqual(6, len(oracle([[0.5, 0.5, 0.5]], 1.0, np.eye(3), inclusive=True)))


if __name__ == "__main__":
    unittest.main()
