# SPDX-License-Identifier: MIT
"""Tensors of torch in CUDA's memory: read where they are, with lists beside them that equal those of the host."""

import unittest

import spherepair

try:
    import torch
    REASON = "" if torch.cuda.is_available() else "torch finds no CUDA device"
except ImportError:
    REASON = "no torch here"
if not REASON and spherepair.backends().get("cuda"):
    REASON = spherepair.backends()["cuda"]


@unittest.skipIf(REASON, REASON)
class CudaArrays(unittest.TestCase):
    def both(self, function, positions, *rest, **options):
        """Calls the function with positions in CUDA's memory and in the host's, and compares the results."""
        def on_host(value):
            return value.cpu() if hasattr(value, "cpu") else value

        made = function(positions.cuda(), *rest, **options)
        wanted = function(positions, *map(on_host, rest), backend="cpu",
                          **{name: on_host(value) for name, value in options.items()})
        for one, other in zip(*((made, wanted) if isinstance(made, tuple) else ([made], [wanted]))):
            self.assertTrue(one.is_cuda)
            self.assertEqual(one.dtype, other.dtype)
            self.assertTrue(torch.equal(one.cpu(), other))
        return made

    def test_lists_are_those_of_the_host(self):
        generator = torch.Generator().manual_seed(5)
        for number in (0, 1, 2, 300, 3000):
            for kind in (torch.float32, torch.float64):
                points = torch.rand((number, 3), generator=generator, dtype=kind) * 7
                cell = [[7, 0, 0], [1, 6.5, 0], [0.5, 0, 8]]
                for options in ({}, {"half": True}, {"pbc": (True, False, True)}, {"index_dtype": "int64"}):
                    self.both(lambda x, **given: spherepair.neighbor_list("ijSdD", x, 1.3, cell, **given), points, **options)
                self.both(spherepair.csr, points, 1.0)
                self.both(spherepair.radius_graph, points, 0.9)

    def test_radii_batches_and_queries(self):
        points = torch.rand((600, 3), dtype=torch.float64) * 5
        batch = torch.arange(600) // 60
        radii = torch.rand(600, dtype=torch.float64) * 0.4
        self.assertGreater(self.both(spherepair.collisions, points, radii.cuda(), batch=batch.cuda()).shape[0], 20)
        self.both(spherepair.collisions, points, 0.3)
        made = spherepair.query(points.cuda(), points[:50].cuda() + 0.01, 0.8)
        wanted = spherepair.query(points, points[:50] + 0.01, 0.8, backend="cpu")
        self.assertTrue(all(torch.equal(one.cpu(), other) for one, other in zip(made, wanted)))

    def test_strided_rows_are_read_where_they_are(self):
        wide = torch.rand((100, 8), device="cuda")
        before = torch.cuda.memory_allocated()
        i, j = spherepair.neighbor_list("ij", wide[:, 2:5], 0.4)
        self.assertEqual(torch.cuda.memory_allocated(), before, "torch allocated nothing: no copy, and lists are the library's")
        self.assertTrue(torch.equal(i.cpu(), spherepair.neighbor_list("i", wide[:, 2:5].cpu(), 0.4, backend="cpu")))

    def test_the_current_stream_is_used(self):
        stream = torch.cuda.Stream()
        base = torch.rand((20000, 3))
        with torch.cuda.stream(stream):
            for turn in range(10):
                shifted = base.cuda(non_blocking=True) + torch.zeros(20000, 3, device="cuda") * turn
                i = spherepair.neighbor_list("i", shifted, 0.05)
                total = i.to(torch.int64).sum()
        stream.synchronize()
        self.assertEqual(int(total), int(spherepair.neighbor_list("i", base, 0.05, backend="cpu").to(torch.int64).sum()))

    def test_lists_outlive_their_context(self):
        context = spherepair.open("cuda")
        i = spherepair.neighbor_list("i", torch.zeros((4, 3), device="cuda"), 1.0, backend=context)
        context.close()
        self.assertEqual(i.tolist(), [0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3])

    def test_wrong_numbers_are_named(self):
        points = torch.zeros((5, 3), device="cuda")
        points[3, 1] = float("nan")
        with self.assertRaisesRegex(ValueError, r"positions\[3\]\.y is nan"):
            spherepair.neighbor_list("ij", points, 1.0)
        with self.assertRaisesRegex(ValueError, "give float64 or float32"):
            spherepair.neighbor_list("ij", points.half(), 1.0)


if __name__ == "__main__":
    unittest.main()
