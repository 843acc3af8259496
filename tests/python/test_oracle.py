# SPDX-License-Identifier: MIT
"""Lists against their definition in rational arithmetic: random points, lattices, slabs, tilted and small boxes."""

import itertools
import unittest

import numpy as np
from support import Case, every_backend, oracle, rows_of, spherepair

OPEN = (False, False, False)
BOXES = [
    ("open", None, OPEN),
    ("cube", np.diag([4.0, 4, 4]), (True, True, True)),
    ("slab", np.diag([4.0, 3, 5]), (True, True, False)),
    ("wire", np.array([[0.3, 0.1, 2.5], [9, 9, 9], [0, 0, 0]]), (True, False, False)),
    ("tilted", np.array([[3.0, 0, 0], [2.5, 3, 0], [-2, 1.5, 3]]), (True, True, True)),
    ("tilted slab", np.array([[3.0, 0.5, 0.25], [-1, 0.1, 3], [1, 2, 3]]), (True, True, False)),
    ("left-handed", np.array([[0, 3.0, 0], [3, 0, 1], [0, 0.5, 4]]), (True, True, True)),
    ("small", np.diag([0.75, 0.5, 0.625]), (True, True, True)),
    ("thin", np.array([[6.0, 0, 0], [5.9, 0.4, 0], [0, 0, 0.9]]), (True, True, True)),
]


class Boxes(Case):
    """All kinds of boxes, with every option."""

    def points_for(self, random, cell, grid):
        points = random.uniform(-3, 5, (5 if cell is not None and np.abs(np.linalg.det(cell)) < 3 else 14, 3))
        return np.round(points * 4) / 4 if grid else points

    @every_backend
    def test_points(self, context):
        random = np.random.default_rng(1)
        for (name, cell, pbc), grid in itertools.product(BOXES, (False, True)):
            points = self.points_for(random, cell, grid)
            for inclusive, half in itertools.product((False, True), repeat=2):
                with self.subTest(box=name, grid=grid, inclusive=inclusive, half=half):
                    self.check_list(context, points, 1.25, cell, pbc, inclusive=inclusive, half=half)

    @every_backend
    def test_spheres_with_skin_and_themselves(self, context):
        random = np.random.default_rng(2)
        for (name, cell, pbc), grid in itertools.product(BOXES, (False, True)):
            points = self.points_for(random, cell, grid)
            radii = random.choice([0, 0.25, 0.5, 0.75], len(points)) if grid else random.uniform(0, 0.7, len(points))
            for inclusive, half in ((False, True), (True, False)):
                with self.subTest(box=name, grid=grid, inclusive=inclusive):
                    self.check_list(context, points, None, cell, pbc, radii=radii, skin=0.25, inclusive=inclusive,
                                    half=half, self_pairs=True)

    @every_backend
    def test_queries(self, context):
        random = np.random.default_rng(3)
        for name, cell, pbc in BOXES:
            points, queries = self.points_for(random, cell, True), self.points_for(random, cell, True)[:4]
            radii, query_radii = random.choice([0, 0.5, 0.75], len(points)), random.choice([0, 0.5], len(queries))
            with self.subTest(box=name):
                found = rows_of(*spherepair.query(points, queries, 1.25, cell, pbc, quantities="ijS", backend=context))
                self.assertEqual(oracle(points, 1.25, cell, pbc, queries=queries), found)
                found = rows_of(*spherepair.query(points, queries, None, cell, pbc, quantities="ijS", radii=radii,
                                                  query_radii=query_radii, inclusive=True, backend=context))
                self.assertEqual(oracle(points, 0.0, cell, pbc, radii, queries=queries, query_radii=query_radii,
                                        inclusive=True), found)

    @every_backend
    def test_vectors_and_distances(self, context):
        random = np.random.default_rng(4)
        for name, cell, pbc in BOXES:
            with self.subTest(box=name):
                self.check_geometry(context, self.points_for(random, cell, False), 1.5, cell, pbc)


class Options(Case):
    @every_backend
    def test_exclusions(self, context):
        random = np.random.default_rng(5)
        points = random.uniform(0, 2, (12, 3))
        exclude = np.array([[0, 1], [5, 2], [3, 3], [2, 5], [11, 0]])
        for half in (False, True):
            found = self.check_list(context, points, 1.5, np.diag([2.0] * 3), exclude=exclude, half=half)
            self.assertLess(len(found), len(self.listed(context, points, 1.5, [2] * 3, half=half)))
        i, j = spherepair.query(points, points[:4], 1.5, exclude=[[3, 3], [1, 7]], backend=context)
        expected = oracle(points, 1.5, queries=points[:4], exclude=[(3, 3), (1, 7)])
        self.assertEqual([row[:2] for row in expected], list(zip(i.tolist(), j.tolist())))

    @every_backend
    def test_batches_sorted_and_not(self, context):
        random = np.random.default_rng(6)
        points, radii = random.uniform(0, 2, (24, 3)), random.uniform(0.2, 0.6, 24)
        exclude = [[0, 9], [4, 17], [23, 1]]
        for batch in (np.sort(random.integers(0, 4, 24)), random.integers(0, 4, 24), random.integers(0, 3, 24) * 1000):
            for half in (False, True):
                self.check_list(context, points, 1.0, np.diag([2.0] * 3), batch=batch, half=half, exclude=exclude)
                self.check_list(context, points, None, batch=batch, radii=radii, half=half, self_pairs=True)
            offsets, neighbours = spherepair.csr(points, 1.0, batch=batch, backend=context)
            i, j = spherepair.neighbor_list("ij", points, 1.0, batch=batch, backend=context)
            self.assertEqual(np.searchsorted(i, np.arange(25)).tolist(), offsets.tolist())
            self.assertEqual(j.tolist(), neighbours.tolist())

    @every_backend
    def test_a_box_for_each_system(self, context):
        random = np.random.default_rng(7)
        cells = np.array([np.diag([2.0, 2, 2]), np.diag([9.0] * 3), [[2.0, 0, 0], [1, 2, 0], [0, 1, 2]], np.eye(3)])
        pbc = np.array([[1, 1, 1], [1, 1, 1], [1, 1, 0], [0, 0, 0]], bool)
        points = random.uniform(0, 2, (21, 3))
        for batch in (np.sort(random.integers(0, 4, 21)), random.integers(0, 4, 21), random.choice([1, 3], 21)):
            for boxes, flags in ((cells, pbc), (cells, [0, 1, 1]), (cells[2], pbc)):
                expected = []
                for system in range(4):
                    members = np.flatnonzero(batch == system)
                    box, periodic = np.broadcast_to(boxes, (4, 3, 3))[system], np.broadcast_to(flags, (4, 3))[system]
                    expected += [(members[i], members[j], *shift)
                                 for i, j, *shift in oracle(points[members], 1.25, box, periodic)]
                self.assertEqual(sorted(expected), self.listed(context, points, 1.25, boxes, flags, batch=batch))

    @every_backend
    def test_queries_of_several_systems(self, context):
        random = np.random.default_rng(8)
        points, queries = random.uniform(0, 2, (20, 3)), random.uniform(0, 2, (9, 3))
        radii, query_radii = random.uniform(0, 0.8, 20), random.uniform(0, 0.8, 9)
        for batch, query_batch in ((np.arange(20) % 3, np.arange(9) % 4), (np.arange(20) // 7, np.arange(9) // 3),
                                   (np.arange(20) // 7, np.arange(9)[::-1] // 3)):
            found = rows_of(*spherepair.query(points, queries, None, [2] * 3, quantities="ijS", radii=radii,
                                              query_radii=query_radii, batch=batch, query_batch=query_batch,
                                              exclude=[[0, 0], [3, 6]], backend=context))
            expected = [row for row in oracle(points, 0.0, np.diag([2.0] * 3), radii=radii, queries=queries,
                                              query_radii=query_radii, exclude=[(0, 0), (3, 6)])
                        if query_batch[row[0]] == batch[row[1]]]
            self.assertGreater(len(expected), 10)
            self.assertEqual(expected, found)

    @every_backend
    def test_unsorted_batches_carry_all_columns(self, context):
        random = np.random.default_rng(9)
        points, batch = random.uniform(0, 2, (30, 3)), random.integers(0, 3, 30)
        i, j, shifts, d, vectors = spherepair.neighbor_list("ijSdD", points, 1.2, [2] * 3, batch=batch, backend=context)
        np.testing.assert_allclose(points[j] - points[i] + 2.0 * shifts, vectors, atol=1e-14)
        np.testing.assert_allclose(np.linalg.norm(vectors, axis=1), d, rtol=1e-15)


if __name__ == "__main__":
    unittest.main()
