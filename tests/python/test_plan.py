# SPDX-License-Identifier: MIT
"""Plans: lists of points that move, in memory that is allocated once."""

import types
import unittest

import numpy as np
from support import Case, every_backend, rows_of, spherepair

RANDOM = np.random.default_rng(1)
POINTS = RANDOM.uniform(0, 4, (60, 3))


class Plans(Case):
    @every_backend
    def test_each_fill_is_the_list_of_its_points(self, context):
        options = dict(cell=[[4, 0, 0], [1, 4, 0], [0, 0, 4]], radii=RANDOM.uniform(0.2, 0.6, 60), half=True,
                       exclude=[[0, 1], [5, 9]], skin=0.125, batch=np.arange(60) // 20)
        plan = spherepair.Plan(POINTS, None, quantities="ijSdD", backend=context, **options)
        for step in range(4):
            x = POINTS + 0.1 * step
            expected = spherepair.neighbor_list("ijSdD", x, backend=context, **options)
            self.assertEqual(len(expected[0]), plan.count(x))
            out = plan.fill(x)
            self.assertEqual((len(expected[0]), False), (out.found, out.overflowed))
            for name, column in zip("ijSdD", expected):
                np.testing.assert_array_equal(column, getattr(out, name))
            np.testing.assert_array_equal(np.searchsorted(expected[0], np.arange(61)), out.offsets)

    @every_backend
    def test_kinds_of_positions(self, context):
        plan = spherepair.Plan(POINTS, 0.9, backend=context)
        expected = plan.fill(POINTS).j.tolist()
        for x in (POINTS.tolist(), np.asfortranarray(POINTS), POINTS[::-1].copy()[::-1]):
            self.assertEqual(expected, plan.fill(x).j.tolist())

    def test_arrays_are_reused_and_grow(self):
        plan = spherepair.Plan(POINTS, 0.9, backend="cpu")
        out = plan.fill(POINTS)
        address = out.i.__array_interface__["data"]
        self.assertIs(out, plan.fill(POINTS + 1))
        self.assertEqual(address, out.i.__array_interface__["data"])
        grown = plan.fill(POINTS / 8)
        self.assertEqual((60 * 59, False), (grown.found, grown.overflowed))
        self.assertGreaterEqual(grown.capacity, grown.found)
        self.assertEqual(60 * 59, len(grown.j))
        self.assertEqual(plan.count(POINTS), plan.fill(POINTS).found)

    def test_a_capacity_is_kept(self):
        plan = spherepair.Plan(POINTS, 0.9, capacity=10, backend="cpu")
        out = plan.fill(POINTS)
        self.assertEqual((10, True, plan.count(POINTS)), (out.capacity, out.overflowed, out.found))
        for name in ("i", "j", "offsets"):
            with self.assertRaisesRegex(spherepair.CapacityError, f"{out.found} pairs, the arrays have 10 rows"):
                getattr(out, name)
        few = plan.fill(POINTS * 4)
        self.assertFalse(few.overflowed)
        self.assertEqual(few.found, len(few.i))

    def test_an_overflow_writes_nothing(self):
        plan = spherepair.Plan(POINTS, 0.9, backend="cpu")
        out = plan.allocate(5)
        self.assertFalse(plan.fill(POINTS * 100, out).found)
        out._columns["i"][:] = 77
        plan.fill(POINTS, out)
        self.assertEqual([77] * 5, out._columns["i"].tolist())

    def test_two_results_beside_each_other(self):
        plan = spherepair.Plan(POINTS, 0.9, quantities="ijS", cell=[4] * 3, backend="cpu")
        one, two = (plan.fill(x, plan.allocate(plan.count(x))) for x in (POINTS, POINTS + 2))
        self.assertEqual(self.check_list("cpu", POINTS, 0.9, [4] * 3), rows_of(one.i, one.j, one.S))
        self.assertEqual(self.check_list("cpu", POINTS + 2, 0.9, [4] * 3), rows_of(two.i, two.j, two.S))

    def test_a_cell_that_changes(self):
        plan = spherepair.Plan(POINTS, 0.9, quantities="ijS", cell=[4] * 3, pbc=[1, 1, 0], backend="cpu")
        for size in (4.0, 4.5, 5.0):
            out = plan.fill(POINTS, cell=[size] * 3)
            self.assertEqual(self.check_list("cpu", POINTS, 0.9, [size] * 3, (1, 1, 0)), rows_of(out.i, out.j, out.S))
        self.assertEqual(out.found, plan.count(POINTS))

    def test_atoms_whose_cell_changes(self):
        atoms = types.SimpleNamespace(get_positions=lambda: POINTS, cell=np.eye(3) * 4, pbc=np.ones(3, bool))
        plan = spherepair.Plan(atoms, 0.9, backend="cpu")
        for size in (4, 6):
            atoms.cell = np.eye(3) * size
            self.assertEqual(len(self.listed("cpu", POINTS, 0.9, [size] * 3)), plan.count(atoms))

    def test_index_types(self):
        out = spherepair.Plan(POINTS, 0.9, quantities="iSd", index_dtype="int64", backend="cpu").fill(POINTS)
        self.assertEqual(["int64", "int64", "float64", "int64"], [str(c.dtype) for c in (out.i, out.S, out.d, out.offsets)])

    def test_faults(self):
        plan = spherepair.Plan(POINTS, 0.9, quantities="ij", cell=[4] * 3, backend="cpu")
        bad = POINTS.copy()
        bad[7, 1] = np.nan
        larger = spherepair.Plan(POINTS[:9], 0.9, backend="cpu").allocate(4000)
        for message, call in (("positions has 9 rows: the plan is for 60 points", lambda: plan.fill(POINTS[:9])),
                              (r"positions\[7\]\.y is nan", lambda: plan.fill(bad)),
                              (r"positions\[7\]\.y is nan", lambda: plan.count(bad)),
                              ("out is for 9 points, the plan for 60", lambda: plan.fill(POINTS, larger)),
                              ("capacity is -1", lambda: plan.allocate(-1)),
                              (r"capacity is \[\[", lambda: spherepair.Plan(POINTS, 0.9, [[1, 0, 0], [0, 1, 0], [0, 0, 1]])),
                              ("cell has 2 boxes: the plan is for 1", lambda: plan.fill(POINTS, cell=[np.eye(3)] * 2)),
                              ("batch is not sorted", lambda: spherepair.Plan(POINTS[:2], 1, batch=[1, 0]))):
            with self.subTest(message=message), self.assertRaisesRegex(ValueError, message):
                call()
        with self.assertRaisesRegex(AttributeError, "'d' is not among the quantities of the plan: make a plan with it"):
            plan.fill(POINTS).d
        with self.assertRaisesRegex(AttributeError, "Pairs has no 'k'"):
            plan.fill(POINTS).k
        self.assertEqual(plan.count(POINTS), plan.fill(POINTS).found)


if __name__ == "__main__":
    unittest.main()
