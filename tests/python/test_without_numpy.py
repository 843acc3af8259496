# SPDX-License-Identifier: MIT
"""The package where numpy cannot be imported: the same lists, as memoryviews. Needs no numpy itself."""

import os
import pathlib
import subprocess
import sys
import textwrap
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BEGIN = """
import array, ctypes, random, sys
sys.modules["numpy"] = None
import spherepair as sp
random.seed(1)
x = [[random.uniform(0, 3) for _ in range(3)] for _ in range(40)]
box = [3, 3, 3]
def check(given, *rest, **options):
    a, b = sp.neighbor_list("ijSdD", x, *rest, backend="cpu", **options), given
    assert [column.tolist() for column in a] == [column.tolist() for column in b]
    assert a[0].nbytes
    return a
def refused(message, function, *arguments, **options):
    try:
        function(*arguments, **options)
    except ValueError as error:
        assert message in str(error), error
    else:
        raise AssertionError("not refused: " + message)
"""


class WithoutNumpy(unittest.TestCase):
    def run_code(self, code):
        run = subprocess.run([sys.executable, "-c", BEGIN + textwrap.dedent(code) + "\nprint('done')"],
                             capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
        self.assertEqual("done\n", run.stdout, run.stderr)

    def test_numpy_is_blocked(self):
        self.run_code("""
            try:
                import numpy
            except ImportError:
                pass
            else:
                raise AssertionError
        """)

    def test_lists_are_memoryviews_with_shapes(self):
        self.run_code("""
            i, j, S, d, D = sp.neighbor_list("ijSdD", x, 1.0, box, backend="cpu")
            n = len(i)
            assert n > 40 and isinstance(i, memoryview)
            assert [c.format for c in (i, j, S, d, D)] == ["i", "i", "i", "d", "d"], (i.format, S.format)
            assert [c.shape for c in (i, j, S, d, D)] == [(n,), (n,), (n, 3), (n,), (n, 3)]
            for k in range(n):
                v = [x[j[k]][a] - x[i[k]][a] + 3 * S[k, a] for a in range(3)]
                assert max(abs(v[a] - D[k, a]) for a in range(3)) < 1e-14 and abs(sum(c * c for c in v)**0.5 - d[k]) < 1e-14
                assert d[k] < 1
            wide = sp.neighbor_list("iS", x, 1.0, box, index_dtype="int64", backend="cpu")
            assert [w.format for w in wide] == ["q", "q"] and wide[0].tolist() == i.tolist() and wide[1].tolist() == S.tolist()
            offsets, neighbours = sp.csr(x, 1.0, box, backend="cpu")
            assert offsets[-1] == n and neighbours.tolist() == j.tolist()
        """)

    def test_empty_lists_have_shapes(self):
        self.run_code("""
            for points in ([], [[0, 0, 0]], [[0, 0, 0], [9, 0, 0]]):
                i, S, D = sp.neighbor_list("iSD", points, 1.0, backend="cpu")
                assert (i.shape, S.shape, D.shape) == ((0,), (0, 3), (0, 3))
                assert S.tolist() == [] and (i.format, S.format, D.format) == ("i", "i", "d")
                assert sp.csr(points, 1.0, backend="cpu")[0].tolist() == [0] * (len(points) + 1)
        """)

    def test_simulations_give_memoryviews(self):
        self.run_code("""
            falling = sp.Simulation([[0, 5.5, 0], [0, 6.25, 0]], 0.5, gravity=8, dt=1 / 64, backend="cpu")
            falling.move(64)
            at = falling.positions
            assert at.shape == (2, 3) and at.format == "f" and abs(at[0, 1] - 1.5) < 1e-5, at.tolist()
            assert abs(falling.velocities[1, 1] + 8) < 1e-5
            assert falling.pairs().tolist() == [[0, 1]]
            resumed = sp.Simulation.resume(falling.checkpoint(), backend="cpu")
            assert resumed.positions == at and resumed.steps == 64
            image = falling.draw(8, 6, samples=2)
            assert image.shape == (6, 8, 4) and image.format == "B" and image[0, 0, 3] == 255, image.tolist()
            mine = memoryview(bytearray(6 * 8 * 4)).cast("B", shape=(6, 8, 4))
            assert resumed.draw(samples=2, out=mine) is mine and mine == image and len(set(mine.tobytes())) > 2
            refused("strides", resumed.draw, out=memoryview(bytearray(12 * 8 * 4)).cast("B", shape=(12, 8, 4))[::2])
        """)

    def test_kinds_of_arrays(self):
        self.run_code("""
            flat = array.array("d", [c for row in x for c in row])
            given = [memoryview(flat).cast("B").cast("d", shape=[40, 3]), memoryview(flat.tobytes()).cast("d", shape=[40, 3]),
                     (ctypes.c_double * 3 * 40).from_buffer(flat), tuple(map(tuple, x))]
            class Interface:
                __array_interface__ = dict(shape=(40, 3), typestr="<f8", data=(flat.buffer_info()[0], False), version=3)
            class Columns:
                data = array.array("d", [row[k] for k in range(3) for row in x])
                __array_interface__ = dict(shape=(40, 3), typestr="<f8", strides=(8, 320), data=(data.buffer_info()[0], True))
            class Swapped:
                data = array.array("d", flat); data.byteswap()
                __array_interface__ = dict(shape=(40, 3), typestr=">f8", data=(data.buffer_info()[0], True), version=3)
            for points in (*given, Interface(), Columns(), Swapped()):
                check(sp.neighbor_list("ijSdD", points, 1.0, box, backend="cpu"), 1.0, box)
            ints = array.array("h", [0, 0, 0, 1, 0, 0])
            assert len(sp.neighbor_list("i", memoryview(ints).cast("B").cast("h", shape=[2, 3]), 2, backend="cpu")) == 2
        """)

    def test_batches_exclusions_queries(self):
        self.run_code("""
            batch = [random.randrange(3) for _ in x]
            r = [random.uniform(0.2, 0.5) for _ in x]
            full = list(zip(*(c.tolist() for c in sp.neighbor_list("ijSdD", x, None, box, radii=r, backend="cpu"))))
            kept = [row for row in full if batch[row[0]] == batch[row[1]]]
            left = [row for row in kept if {row[0], row[1]} != {kept[0][0], kept[0][1]}]
            found = sp.neighbor_list("ijSdD", x, None, box, radii=r, batch=batch, exclude=[kept[0][:2]], backend="cpu")
            assert left and list(zip(*(c.tolist() for c in found))) == left
            offsets, j = sp.csr(x, None, box, radii=r, batch=batch, backend="cpu")
            assert j.tolist() == [row[1] for row in kept]
            assert offsets.tolist() == [sum(row[0] < k for row in kept) for k in range(41)]
            i, j = sp.query(x, x[:9], None, box, radii=r, query_radii=r[:9], batch=batch, query_batch=batch[:9], backend="cpu")
            mine = [(a, a) for a in range(9)] + [row[:2] for row in kept if row[0] < 9]
            assert list(zip(i, j)) == sorted(mine)
            cells = [[[3, 0, 0], [0, 3, 0], [0, 0, 3]]] * 3
            many = sp.neighbor_list("ijSdD", x, None, cells, radii=r, batch=batch, backend="cpu")
            assert list(zip(*(c.tolist() for c in many))) == kept
            refused("batch[1] is 3", sp.neighbor_list, "i", x, 1.0, cells, batch=[0, 3] + [0] * 38)
        """)

    def test_other_functions(self):
        self.run_code("""
            assert sp.radius_graph([0, 1, 9], 2, backend="cpu").tolist() == [[1, 0], [0, 1]]
            assert sp.radius_graph([[0, 0], [1, 0]], 2, backend="cpu").shape == (2, 2)
            assert sp.radius_graph([], 2, backend="cpu").shape == (2, 0)
            assert sp.collisions(x[:2] + x[:1], 0.01, backend="cpu").tolist() == [[0, 2]]
            plan = sp.Plan(x, 1.0, quantities="ijSd", cell=box, backend="cpu")
            out = plan.fill(x)
            i, j, S, d = sp.neighbor_list("ijSd", x, 1.0, box, backend="cpu")
            assert out.found == plan.count(x) == len(i)
            assert [c.tolist() for c in (out.i, out.j, out.S, out.d)] == [c.tolist() for c in (i, j, S, d)]
            assert out.offsets[40] == out.found
        """)

    def test_outputs_with_strides(self):
        self.run_code("""
            from spherepair import _views, _without_numpy
            numbers = array.array("d", range(6))
            view = _views.View(numbers.buffer_info()[0], (2, 3), (8, 16), "f8", True, numbers)
            assert _without_numpy.output(view).tolist() == [[0, 2, 4], [1, 3, 5]]
        """)

    def test_messages(self):
        self.run_code("""
            refused("positions[1].y is nan", sp.neighbor_list, "i", [[0, 0, 0], [0, float("nan"), 0]], 1)
            refused("positions[1] has 2 elements", sp.neighbor_list, "i", [[0, 0, 0], [0, 0]], 1)
            refused("positions[2].x is nan", sp.neighbor_list, "i", [[0, 0, 0]] * 2 + [[float("nan"), 0, 0]], 1, batch=[1, 1, 0])
            refused("positions has the integer", sp.neighbor_list, "i", [[2**53 + 1, 0, 0]], 1)
            refused("positions has shape (3,)", sp.neighbor_list, "i", b"abc", 1)
        """)


if __name__ == "__main__":
    unittest.main()
