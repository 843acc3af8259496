# SPDX-License-Identifier: MIT
"""What other packages have in place of arrays: torch's tensors, ASE's atoms."""

import types
import unittest
from unittest import mock

import numpy as np
from support import spherepair
from test_arrays import POINTS, Dlpack


class Tensor:
    """Stands for a tensor of torch in the host's memory."""

    requires_grad = True

    def __init__(self, numbers):
        self.numbers = numbers

    def detach(self):
        return Dlpack(self.numbers)

    def __dlpack__(self):
        raise BufferError("a tensor that requires a gradient cannot be exported")


class Torch(unittest.TestCase):
    def test_tensors_give_tensors(self):
        torch = types.SimpleNamespace(Tensor=Tensor, from_numpy=Tensor)
        given = Tensor(POINTS)
        with mock.patch.dict("sys.modules", torch=torch):
            i, d = spherepair.neighbor_list("id", given, 0.4, backend="cpu")
            results = [i, d, spherepair.radius_graph(given, 0.4, backend="cpu"),
                       spherepair.collisions(given, 0.2, backend="cpu"), *spherepair.csr(given, 0.4, backend="cpu"),
                       spherepair.Plan(given, 0.4, backend="cpu").fill(given).i]
            self.assertNotIsInstance(spherepair.neighbor_list("i", POINTS, 0.4, backend="cpu"), Tensor)
        for result in results:
            self.assertIsInstance(result, Tensor)
        np.testing.assert_array_equal(spherepair.neighbor_list("d", POINTS, 0.4, backend="cpu"), d.numbers)


class Atoms:
    """Stands for ase.Atoms."""

    cell, pbc = np.diag([2.0, 2, 9]), np.array([True, True, False])

    def get_positions(self):
        return POINTS


class AtomsLike(unittest.TestCase):
    def test_positions_cell_and_pbc_are_taken(self):
        expected = spherepair.neighbor_list("ijS", POINTS, 0.4, Atoms.cell, Atoms.pbc, backend="cpu")
        self.assertTrue(expected[2].any())
        for ours, theirs in zip(expected, spherepair.neighbor_list("ijS", Atoms(), 0.4, backend="cpu")):
            np.testing.assert_array_equal(ours, theirs)
        self.assertEqual(len(expected[0]), spherepair.Plan(Atoms(), 0.4, backend="cpu").count(Atoms()))
        self.assertEqual(len(expected[0]), spherepair.radius_graph(Atoms(), 0.4, backend="cpu").shape[1])

    def test_ase(self):
        try:
            from ase import neighborlist
            from ase.build import bulk
        except ImportError:
            self.skipTest("ASE is not installed")
        atoms = bulk("NaCl", "rocksalt", a=5.64) * (2, 2, 2)
        atoms.rattle(0.1, seed=1)
        expected = neighborlist.neighbor_list("ijS", atoms, 4.5)
        found = spherepair.neighbor_list("ijS", atoms, 4.5, backend="cpu")
        rows = [sorted(map(tuple, np.column_stack(columns).tolist())) for columns in (expected, found)]
        self.assertEqual(*rows)


if __name__ == "__main__":
    unittest.main()
