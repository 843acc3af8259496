# SPDX-License-Identifier: MIT
"""Lists of some thousand points against scipy's k-d tree, in open and orthorhombic boxes, and by counting in others."""

import unittest

import numpy as np
from scipy.spatial import cKDTree
from support import Case, every_backend, spherepair


def directed(points, cutoff, box):
    half = cKDTree(points, boxsize=box).query_pairs(cutoff, output_type="ndarray")
    both = np.concatenate((half, half[:, ::-1]))
    return both[np.lexsort((both[:, 1], both[:, 0]))]


class Trees(Case):
    @every_backend
    def test_open_and_orthorhombic_boxes(self, context):
        random = np.random.default_rng(1)
        for count, size, box, cutoff in ((4000, [10, 10, 10], None, 0.7), (4000, [10, 7, 23], [10, 7, 23], 1.1),
                                         (2500, [40, 40, 0.5], None, 0.8), (3000, [12, 12, 12], [12, 12, 12], 0.05)):
            points = random.uniform(0, 1, (count, 3)) * size
            i, j = spherepair.neighbor_list("ij", points, cutoff, box, backend=context)
            with self.subTest(count=count, size=size, box=box):
                np.testing.assert_array_equal(directed(points, cutoff, box), np.column_stack((i, j)))

    @every_backend
    def test_clusters(self, context):
        random = np.random.default_rng(2)
        points = random.uniform(0, 1000, (40, 1, 3)) + random.normal(0, 0.5, (40, 50, 3))
        points = points.reshape(-1, 3)
        i, j = spherepair.neighbor_list("ij", points, 0.6, backend=context)
        np.testing.assert_array_equal(directed(points, 0.6, None), np.column_stack((i, j)))

    @every_backend
    def test_queries(self, context):
        random = np.random.default_rng(3)
        points, queries = random.uniform(0, 5, (3000, 3)), random.uniform(0, 5, (700, 3))
        near = cKDTree(queries, boxsize=5).query_ball_tree(cKDTree(points, boxsize=5), 0.6)
        expected = [(a, b) for a, row in enumerate(near) for b in sorted(row)]
        i, j = spherepair.query(points, queries, 0.6, [5] * 3, backend=context)
        self.assertEqual(expected, list(zip(i.tolist(), j.tolist())))

    @every_backend
    def test_a_tilted_description_of_the_same_lattice(self, context):
        """Rows with integer multiples of other rows added describe one crystal: distances are the same."""
        random = np.random.default_rng(4)
        straight = np.diag([8.0, 8, 8])
        tilted = straight + np.array([[0, 0, 0], [8, 0, 0], [-16, 8, 0]])
        points = random.integers(0, 4096, (1500, 3)) / 512
        lists = [spherepair.neighbor_list("ijD", points, 1.5, cell, backend=context) for cell in (straight, tilted)]
        a, b = [np.column_stack((i, j, vectors)) for i, j, vectors in lists]
        np.testing.assert_array_equal(a[np.lexsort(a.T[::-1])], b[np.lexsort(b.T[::-1])])

    @every_backend
    def test_half_and_full_lists_agree(self, context):
        points = np.random.default_rng(5).uniform(0, 6, (2000, 3))
        cell = [[6, 0, 0], [2, 5, 0], [1, 1, 6]]
        full = np.column_stack(spherepair.neighbor_list("ijS", points, 1.0, cell, backend=context))
        half = np.column_stack(spherepair.neighbor_list("ijS", points, 1.0, cell, half=True, backend=context))
        back = np.column_stack((half[:, 1], half[:, 0], -half[:, 2:]))
        both = np.concatenate((half, back))
        np.testing.assert_array_equal(full, both[np.lexsort(both.T[::-1])])


if __name__ == "__main__":
    unittest.main()
