# SPDX-License-Identifier: MIT
"""Reports of users of other neighbour lists, by their numbers in the catalogue: points, numbers, sizes, graphs."""

import unittest

import numpy as np
from scipy.spatial import cKDTree
from support import Case, every_backend, rows_of, spherepair

CORNERS = [[-1.0, -1], [-1, 1], [1, -1], [1, 1]]


def tree_pairs(points, cutoff, box=None):
    """The half list of scipy, for points in [0, box)."""
    return {tuple(pair) for pair in cKDTree(points, boxsize=box).query_pairs(cutoff, output_type="ndarray").tolist()}


class Points(Case):
    @every_backend
    def test_04_two_points_at_one_place(self, context):
        """Luthaf/vesin, cuda/bruteforce.cu"""
        for cell in (None, [9, 9, 9]):
            self.assertEqual([(0, 1, 0, 0, 0)], self.check_list(context, [[1, 2, 3]] * 2, 1.0, cell, half=True))

    @every_backend
    def test_06_more_neighbours_than_expected(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#1"""
        points = np.mod(np.random.default_rng(6).normal(0, 1, (1000, 3)), 10)
        i, j = spherepair.neighbor_list("ij", points, 2.5, [10] * 3, half=True, backend=context)
        self.assertEqual(tree_pairs(points, 2.5, 10), set(zip(i.tolist(), j.tolist())))
        self.assertGreater(np.bincount(np.append(i, j)).max(), 256)

    @every_backend
    def test_10_a_dense_cluster_and_a_short_cutoff(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#114"""
        points = np.random.default_rng(10).normal(50, 1e-4, (300, 3))
        self.assertEqual(300 * 299, len(spherepair.neighbor_list("i", points, 0.01, [100] * 3, backend=context)))

    @every_backend
    def test_11_overflow_names_needed_and_given(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#159"""
        plan = spherepair.Plan([[0, 0, 0]] * 5, 1.0, capacity=7, backend=context)
        with self.assertRaises(spherepair.CapacityError) as caught:
            plan.fill([[0, 0, 0]] * 5).i
        self.assertEqual((20, 7), (caught.exception.needed, caught.exception.given))
        out = plan.fill([[0, 0, 0]] * 5, plan.allocate(caught.exception.needed))
        self.assertEqual((20, False, 20), (out.found, out.overflowed, len(out.i)))

    @every_backend
    def test_12_cutoffs_of_several_bins(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#128"""
        random = np.random.default_rng(12)
        points, queries = random.uniform(0, 1, (128, 3)), random.uniform(0, 1, (128, 3))
        for cutoff in (0.1, 0.18, 0.3, 0.45):
            i, j = spherepair.query(points, queries, cutoff, [1] * 3, backend=context)
            near = cKDTree(queries, boxsize=1).query_ball_tree(cKDTree(points, boxsize=1), cutoff)
            self.assertEqual([(a, b) for a, row in enumerate(near) for b in sorted(row)], list(zip(i.tolist(), j.tolist())))

    @every_backend
    def test_13_two_runs_give_equal_bits(self, context):
        """NVIDIA/nvalchemi-toolkit-ops#135"""
        points = np.tile(np.random.default_rng(13).uniform(0, 8, (24, 3)), (8, 1))
        runs = [spherepair.neighbor_list("ijSdD", points, 15, batch=np.repeat(np.arange(8), 24), backend=context)
                for _ in range(2)]
        self.assertEqual(4416, len(runs[0][0]))
        self.assertEqual([column.tobytes() for column in runs[0]], [column.tobytes() for column in runs[1]])

    @every_backend
    def test_14_no_edge_joins_two_waters(self, context):
        """NVIDIA/nvalchemi-toolkit#106"""
        water = np.array([[0, 0, 0.119], [0, 0.763, -0.477], [0, -0.763, -0.477]])
        batch = np.repeat(np.arange(4), 3)
        i, j = spherepair.neighbor_list("ij", np.tile(water, (4, 1)), 1.2, batch=batch, backend=context)
        self.assertEqual(16, len(i))
        np.testing.assert_array_equal(batch[i], batch[j])

    @every_backend
    def test_15_a_skin_holds_while_points_move_and_wrap(self, context):
        """NVIDIA/nvalchemi-toolkit#151"""
        random = np.random.default_rng(15)
        points = random.uniform(0, 8, (40, 3))
        points[:6] = random.uniform(0, 0.1, (6, 3))
        wide = spherepair.neighbor_list("ijS", points, 2.0, [8] * 3, skin=0.5, backend=context)
        moved = points + random.uniform(-0.14, 0.14, points.shape)
        self.assertLessEqual(set(self.listed(context, moved, 2.0, [8] * 3)), set(rows_of(*wide)))
        cells = np.floor(moved / 8).astype(int)
        self.assertTrue(cells.any())
        wrapped = self.listed(context, moved - 8 * cells, 2.0, [8] * 3)
        back = [(i, j, *(shift + cells[i] - cells[j]).tolist()) for i, j, *shift in map(np.array, wrapped)]
        self.assertEqual(self.listed(context, moved, 2.0, [8] * 3), sorted(map(tuple, np.array(back).tolist())))

    @every_backend
    def test_17_every_edge_is_there(self, context):
        """rusty1s/pytorch_cluster#128, #219"""
        self.assertEqual((2, 6), spherepair.radius_graph([0.0, 1, 2], 2.5, backend=context).shape)
        self.assertEqual((2, 12), spherepair.radius_graph(CORNERS, 100, backend=context).shape)

    @every_backend
    def test_18_queries_against_corners(self, context):
        """rusty1s/pytorch_cluster#79"""
        points = [[*corner, 0] for corner in CORNERS]
        i, j = spherepair.query(points, [[-1, 0, 0], [1, 0, 0]], 10, backend=context)
        self.assertEqual(([0] * 4 + [1] * 4, [0, 1, 2, 3] * 2), (i.tolist(), j.tolist()))

    @every_backend
    def test_19_graphs_are_symmetric(self, context):
        """pyg-team/pytorch_geometric#1867"""
        edges = spherepair.radius_graph(np.random.default_rng(19).uniform(0, 5, (60, 3)), 10, backend=context).T.tolist()
        self.assertEqual(60 * 59, len(edges))
        self.assertEqual({(a, b) for a, b in edges}, {(b, a) for a, b in edges})

    @every_backend
    def test_20_a_batch_that_is_not_sorted(self, context):
        """pyg-team/pytorch_geometric#10254"""
        x = [[0.0, 1], [1, 1], [10, 10], [10, 11]]
        self.assertEqual((2, 0), spherepair.radius_graph(x, 5, [0, 1, 0, 1], backend=context).shape)
        edges = spherepair.radius_graph(x, 50, [0, 1, 0, 2], backend=context)
        self.assertEqual([[2, 0], [0, 2]], edges.tolist())

    @every_backend
    def test_22_cells_of_negative_coordinates(self, context):
        """NVIDIA/warp#1256"""
        i, j = spherepair.query([[-0.3, 0, 0]], [[0.2, 0, 0]], 0.6, backend=context)
        self.assertEqual(([0], [0]), (i.tolist(), j.tolist()))

    @every_backend
    def test_24_ties_on_the_numbers_as_given(self, context):
        """scipy/scipy#16600"""
        s = np.sqrt(2)
        line = np.linspace(0, 3 * s, 4)
        grid = [(x, y, 0) for x in line for y in line]
        self.assertEqual(16, len(self.check_list(context, grid, s, half=True, inclusive=True)))
        self.assertEqual(24, len(self.check_list(context, grid, s * (1 + 1e-9), half=True, inclusive=True)))

    @every_backend
    def test_25_numbers_that_are_not_finite(self, context):
        """scipy/scipy#14793"""
        np.random.seed(1)
        points = np.pad(np.random.standard_normal((1000, 2)), ((0, 0), (0, 1)))
        self.assertEqual(1240, len(spherepair.neighbor_list("i", points, 0.1, half=True, backend=context)))
        for bad in (np.nan, np.inf, -np.inf):
            with self.assertRaisesRegex(ValueError, r"positions\[1000\]\.x is -?(nan|inf)"):
                spherepair.neighbor_list("i", np.append(points, [[bad] * 3] * 5, 0), 0.1, backend=context)

    @every_backend
    def test_27_two_sets_and_the_centre(self, context):
        """MDAnalysis/mdanalysis#2919, #2229"""
        random = np.random.default_rng(27)
        a, b = random.uniform(0, 6, (40, 3)), random.uniform(0, 6, (50, 3))
        a[0] = b[0] = 3.0
        one = rows_of(*spherepair.query(a, b, 2.0, [6] * 3, quantities="ijS", backend=context))
        other = rows_of(*spherepair.query(b, a, 2.0, [6] * 3, quantities="ijS", backend=context))
        self.assertIn((0, 0, 0, 0, 0), one)
        self.assertEqual(one, sorted((j, i, -x, -y, -z) for i, j, x, y, z in other))

    @every_backend
    def test_29_cutoffs_next_to_a_distance(self, context):
        """MDAnalysis/mdanalysis#4906"""
        points = np.random.default_rng(29).uniform(0, 4, (8, 3))
        for d in np.unique(spherepair.neighbor_list("d", points, 3.5, [4] * 3, half=True, backend=context))[::9]:
            for cutoff in (np.nextafter(d, 0), d, np.nextafter(d, 9)):
                self.check_list(context, points, float(cutoff), [4] * 3, half=True)

    @every_backend
    def test_37_degenerate_extents(self, context):
        """openkim/kliff#37"""
        for other in ([4, 3, 3], [4, 4, 3]):
            self.assertEqual(1, len(self.listed(context, [[3, 3, 3], other], 1.5, half=True)))

    @every_backend
    def test_38_numbers_of_points_near_powers_of_two(self, context):
        """proteneer/timemachine#663"""
        random = np.random.default_rng(38)
        for count in [n + k for n in (32, 64, 256, 1024) for k in (-1, 0, 1)]:
            points = random.uniform(0, 1, (count, 3))
            i, j = spherepair.neighbor_list("ij", points, 0.2, half=True, backend=context)
            self.assertEqual(tree_pairs(points, 0.2), set(zip(i.tolist(), j.tolist())), count)

    @every_backend
    def test_39_empty_lists_have_shapes_and_types(self, context):
        """wcwitt/symmetrix#81"""
        for points in ([[0, 0, 0], [10, 0, 0]], [], np.empty((0, 3)), [[1, 2, 3]]):
            i, shifts, d, vectors = spherepair.neighbor_list("iSdD", points, 3, backend=context)
            self.assertEqual([(0,), (0, 3), (0,), (0, 3)], [column.shape for column in (i, shifts, d, vectors)])
            self.assertEqual(["int32", "int32", "float64", "float64"], [str(c.dtype) for c in (i, shifts, d, vectors)])
            offsets, neighbours = spherepair.csr(points, 3, backend=context)
            self.assertEqual(([0] * (len(points) + 1), (0,)), (offsets.tolist(), neighbours.shape))

    @every_backend
    def test_40_cutoffs_that_are_nothing(self, context):
        """materialsproject/pymatgen#2277"""
        points = np.random.default_rng(40).uniform(0, 1e3, (50, 3))
        for cutoff in (0, 1e-9):
            self.assertEqual([], self.listed(context, points, cutoff, [1e3] * 3))
        with self.assertRaisesRegex(ValueError, "cutoff is -1"):
            self.listed(context, points, -1)

    @every_backend
    def test_41_arrays_for_an_empty_list(self, context):
        """jax-md/jax-md#165, #168"""
        plan = spherepair.Plan([[-40, 0, 0], [40, 0, 0]], 3, 0, cell=[100] * 3, half=True, backend=context)
        self.assertEqual((0, False), (plan.fill([[-40, 0, 0], [40, 0, 0]]).found, plan.fill([[0, 1, 2], [50, 1, 2]]).overflowed))
        out = plan.fill([[-40, 0, 0], [-40, 0, 0]])
        self.assertEqual((1, True), (out.found, out.overflowed))


if __name__ == "__main__":
    unittest.main()
