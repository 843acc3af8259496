# SPDX-License-Identifier: MIT
"""Plans for torch's tensors in CUDA's memory, and CUDA graphs of their fills."""

import unittest

import spherepair
from test_cuda_arrays import REASON

if not REASON:
    import torch

CELL = [[7, 0, 0], [1, 6.5, 0], [0.5, 0, 8]]


@unittest.skipIf(REASON, REASON)
class CudaGraphs(unittest.TestCase):
    def setUp(self):
        self.generator = torch.Generator(device="cuda").manual_seed(46)

    def points(self, rows=3000):
        return torch.rand((rows, 3), generator=self.generator, device="cuda", dtype=torch.float64) * 7

    def check(self, out, x, quantities="ijSdD", cell=CELL, **options):
        """Compares the list with one that is made at once. Columns must be those of the list, bit for bit."""
        wanted = spherepair.neighbor_list(quantities, x, 0.9, cell, **options)
        self.assertEqual((len(wanted[0]), False), (out.found, out.overflowed))
        for name, column in zip(quantities, wanted):
            self.assertTrue(getattr(out, name).is_cuda)
            self.assertTrue(torch.equal(getattr(out, name), column), name)
        self.assertEqual(out.offsets[-1], out.found)

    def captured(self, plan, x, out=None):
        plan.fill(x, out)
        graph = torch.cuda.CUDAGraph()
        with torch.cuda.graph(graph):
            made = plan.fill(x, out)
        return graph, made

    def test_a_graph_follows_the_positions(self):
        for code in ("int32", "int64"):  # int32 is written in place, int64 is copied
            x = self.points()
            plan = spherepair.Plan(x, 0.9, 200_000, "ijSdD", CELL, index_dtype=code)
            graph, out = self.captured(plan, x)
            addresses = {name: column.data_ptr() for name, column in out.columns.items()}
            for _ in range(3):
                x.copy_(self.points())
                graph.replay()
                self.check(out, x, index_dtype=code)  # by another context: the graph stays valid
            self.assertEqual(addresses, {name: column.data_ptr() for name, column in out.columns.items()})

    def test_a_graph_that_has_too_little_room(self):
        x = self.points()
        needed = len(spherepair.neighbor_list("i", x, 0.9))
        plan = spherepair.Plan(x, 0.9, needed - 1, "ijSdD")
        graph, out = self.captured(plan, x)
        for name, column in out.columns.items():
            column.fill_(-7)
        graph.replay()
        with self.assertRaises(spherepair.CapacityError) as caught:
            out.i
        self.assertEqual((needed, needed - 1), (caught.exception.needed, caught.exception.given))
        for name in "ijSdD":
            self.assertTrue(bool((out.columns[name] == -7).all()), "no pair is written")
        x.mul_(3)  # fewer pairs: there is room
        graph.replay()
        self.check(out, x, cell=None)

    def test_too_little_room_without_a_graph(self):
        x = self.points()
        needed = len(spherepair.neighbor_list("i", x, 0.9, CELL))
        plan = spherepair.Plan(x, 0.9, 5, cell=CELL)
        for _ in range(2):  # the first fill waits, the second does not
            out = plan.fill(x)
            self.assertEqual((needed, True, needed), (out.found, out.overflowed, int(out.columns["found"][0])))

    def test_columns_of_the_callers(self):
        x = self.points()
        plan = spherepair.Plan(x, 0.9, quantities="ij", cell=CELL)
        table = torch.full((2, 200_000), -7, dtype=torch.int32, device="cuda")
        found = torch.zeros(1, dtype=torch.int64, device="cuda")
        out = plan.into(i=table[0], j=table[1], found=found)
        graph, made = self.captured(plan, x, out)
        self.assertIs(out, made)
        x.copy_(self.points())
        graph.replay()
        i, j = spherepair.neighbor_list("ij", x, 0.9, CELL)
        self.assertEqual(len(i), int(found))
        self.assertTrue(torch.equal(torch.stack((i, j)), table[:, :len(i)]))
        self.assertEqual((table[0].data_ptr(), found.data_ptr()), (out.i.data_ptr(), out.columns["found"].data_ptr()))

    def test_fills_allocate_nothing_and_do_not_wait(self):
        x = self.points()
        plan = spherepair.Plan(x, 0.9, 200_000, "ijSdD", CELL)
        asleep = torch.cuda.Event()
        for cycles in (1, 2_000_000_000):  # the second takes about a second
            plan.fill(x)
            torch.cuda.synchronize()
            before = torch.cuda.memory_allocated(), torch.cuda.mem_get_info()
            torch.cuda._sleep(cycles)
            asleep.record()
        for _ in range(5):
            out = plan.fill(x)
        self.assertFalse(asleep.query(), "no fill has waited")
        self.assertEqual(before, (torch.cuda.memory_allocated(), torch.cuda.mem_get_info()))
        self.check(out, x)

    def test_fills_follow_the_current_stream(self):
        base, stream = self.points(20000), torch.cuda.Stream()
        plan = spherepair.Plan(base, 0.2, 400_000)
        plan.fill(base)
        torch.cuda.synchronize()
        with torch.cuda.stream(stream):
            for turn in range(10):
                torch.cuda._sleep(10_000_000)
                shifted = base + turn
                out = plan.fill(shifted)
            last = out.i.clone()
        stream.synchronize()
        self.assertTrue(torch.equal(last, spherepair.neighbor_list("i", base + 9, 0.2)))

    def test_arrays_grow_without_a_capacity(self):
        x = self.points()
        plan = spherepair.Plan(x, 0.9, quantities="ijSdD", cell=CELL)
        for factor in (1.0, 0.5, 2.0):
            self.check(plan.fill(x * factor), x * factor)
        self.assertNotIn("found", plan.fill(x).columns)

    def test_a_cell_that_changes_is_followed_outside_of_graphs(self):
        x = self.points()
        plan = spherepair.Plan(x, 0.9, 400_000, "ij", CELL)
        for size in (8.0, 9.0):
            out = plan.fill(x, cell=torch.eye(3, device="cuda") * size)
            self.assertEqual(len(spherepair.neighbor_list("i", x, 0.9, [size] * 3)), out.found)

    def test_fills_that_cannot_be_captured(self):
        x = self.points()
        grows, fixed = spherepair.Plan(x, 0.9, cell=CELL), spherepair.Plan(x, 0.9, 200_000, cell=CELL)
        grows.fill(x)
        for plan in (grows, fixed):
            with torch.cuda.graph(torch.cuda.CUDAGraph()):
                x.add_(0)  # torch warns of an empty graph
                with self.assertRaisesRegex(ValueError, "this fill cannot be captured"):
                    plan.fill(x)
        self.check(self.captured(fixed, x)[1], x, "ij")

    def test_numbers_that_cannot_be_listed(self):
        x = self.points(50)
        plan = spherepair.Plan(x, 0.9, 5000)
        graph, out = self.captured(plan, x)
        x[17, 1] = float("nan")
        graph.replay()
        with self.assertRaisesRegex(ValueError, r"positions\[17\] cannot be listed"):
            out.i
        with self.assertRaisesRegex(ValueError, r"positions\[17\]\.y is nan"):
            plan.count(x)


if __name__ == "__main__":
    unittest.main()
