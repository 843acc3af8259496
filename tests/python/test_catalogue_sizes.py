# SPDX-License-Identifier: MIT
"""Reports of users of other neighbour lists, by their numbers in the catalogue: large lists, memory, installation."""

import itertools
import resource
import subprocess
import sys
import unittest

import numpy as np
from scipy.spatial import cKDTree
from support import CONTEXTS, MISSING, ROOT, Case, every_backend, spherepair
from test_cuda_arrays import REASON as NO_CUDA

SPARSE = np.random.default_rng(43).uniform(0, 100, (140_000, 3))


class Sizes(Case):
    @unittest.skip("5 billion pairs take 40 GB and more: the count's 64 bits are checked by its type alone")
    def test_42_all_pairs_of_100000_points(self):
        """plumed/plumed2#977"""

    @every_backend
    def test_43_more_than_128k_points(self, context):
        """openmm/NNPOps#101"""
        offsets, neighbours = spherepair.csr(SPARSE, 1.0, backend=context)
        self.assertEqual(("int64", len(SPARSE) + 1), (str(offsets.dtype), len(offsets)))
        self.assertEqual(2 * len(cKDTree(SPARSE).query_pairs(1.0, output_type="ndarray")), offsets[-1])
        self.assertEqual(offsets[-1], len(neighbours))

    @every_backend
    def test_44_more_than_1024_neighbours(self, context):
        """brucefan1983/GPUMD#1525"""
        points = np.random.default_rng(44).uniform(0, 0.5, (1100, 3))
        self.assertEqual(1100 * 1099, len(spherepair.neighbor_list("i", points, 1.0, backend=context)))

    @every_backend
    def test_45_memory_stays_flat(self, context):
        """glotzerlab/hoomd-blue#1289"""
        points = np.random.default_rng(45).uniform(0, 10, (2000, 3))

        def grown(calls):
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            for _ in range(calls):
                spherepair.neighbor_list("ijSdD", points, 2.0, backend=context)
            return (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024

        grown(5)
        self.assertLess(grown(20), 25.0, "MiB: one list of these has about 7")

    @unittest.skipIf(NO_CUDA, NO_CUDA)
    def test_46_capture_and_replay(self):
        """pyg-team/pyg-lib#673"""
        import torch
        x = torch.rand((500, 3), device="cuda")
        plan = spherepair.Plan(x, 0.2, capacity=100_000)
        plan.fill(x)
        graph = torch.cuda.CUDAGraph()
        with torch.cuda.graph(graph):
            out = plan.fill(x)
        for _ in range(3):
            x.uniform_()
            graph.replay()
            i, j = spherepair.neighbor_list("ij", x, 0.2)
            self.assertTrue(torch.equal(out.i, i) and torch.equal(out.j, j))

    @every_backend
    def test_47_mixed_radii(self, context):
        """readdy/readdy#195"""
        random = np.random.default_rng(47)
        for ratio in (7, 150):
            centers = random.uniform(0, 20, (900, 3))
            radii = np.where(random.random(900) < 0.02, ratio / 40, 1 / 40) * random.uniform(0.5, 1, 900)
            gaps = np.linalg.norm(centers[:, None] - centers, axis=2) - (radii[:, None] + radii)
            expected = np.argwhere(np.triu(gaps < 0, 1))
            self.assertGreater(abs(gaps[~np.eye(900, dtype=bool)]).min(), 1e-12)
            np.testing.assert_array_equal(expected, spherepair.collisions(centers, radii, backend=context))

    @every_backend
    def test_49_ties_have_equal_distances_and_an_order(self, context):
        """WatChMaL/WatChMaL#123"""
        lattice = list(itertools.product(range(4), repeat=3))
        i, j, d = spherepair.neighbor_list("ijd", lattice, 1.5, [4] * 3, backend=context)
        self.assertEqual({1.0: 6 * 64, float(np.sqrt(2)): 12 * 64}, dict(zip(*np.unique(d, return_counts=True))))
        self.assertEqual(sorted(zip(i.tolist(), j.tolist())), list(zip(i.tolist(), j.tolist())))

    def test_50_one_binary_and_reasons(self):
        """pyg-team/pytorch_geometric#9789"""
        self.assertEqual({"cpu", "opengl", "cuda", "vulkan"}, set(MISSING))
        self.assertIsNone(MISSING["cpu"])
        for name in set(MISSING) - set(CONTEXTS):
            self.assertGreater(len(MISSING[name]), 10, name)
        code = "import spherepair, sys; print(sorted({'torch', 'cupy', 'jax', 'ase'} & set(sys.modules)))"
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT / "python")
        self.assertEqual("[]\n", run.stdout, run.stderr)


if __name__ == "__main__":
    unittest.main()
