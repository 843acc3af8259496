# SPDX-License-Identifier: MIT
"""The kinds of arrays that are taken and given: strides, orders, types, protocols."""

import array
import ctypes
import types
import unittest

import numpy as np
from support import spherepair

from spherepair import _dlpack, _inputs

RANDOM = np.random.default_rng(1)
POINTS = RANDOM.integers(0, 2048, (50, 3)) / 1024  # float32 has them, too


class Dlpack:
    """Has nothing but __dlpack__."""

    def __init__(self, numbers, device=(1, 0)):
        self.numbers, self.device = numbers, device

    def __dlpack__(self):
        return self.numbers.__dlpack__()

    def __dlpack_device__(self):
        return self.device


class Interface:
    """Has nothing but __array_interface__."""

    def __init__(self, numbers):
        self.numbers, self.__array_interface__ = numbers, numbers.__array_interface__


class Frame:
    """Has nothing but __array__, as tables do."""

    def __array__(self, dtype=None):
        return np.asarray(POINTS, dtype)


def wide(dtype):
    numbers = np.full((100, 7), np.nan, dtype)
    numbers[::2, 1:6:2] = POINTS
    return numbers[::2, 1:6:2]


def records():
    """Positions inside records of 28 bytes: strides are no multiple of 8."""
    made = np.zeros(50, np.dtype([("at", "<f8", 3), ("charge", "<f4")]))
    made["at"] = POINTS
    return made["at"]


def misplaced():
    """Positions at an odd address."""
    return np.frombuffer(b"x" + POINTS.tobytes(), "u1")[1:].view("f8").reshape(50, 3)


def read_only():
    numbers = POINTS.copy()
    numbers.flags.writeable = False
    return numbers


CTYPES = (ctypes.c_double * 3 * 50)(*[(ctypes.c_double * 3)(*row) for row in POINTS.tolist()])
WITHOUT_COPY = {
    "C order": POINTS, "Fortran order": np.asfortranarray(POINTS), "float32": POINTS.astype("f4"), "strided": wide("f8"),
    "strided float32": wide("f4"), "backwards": POINTS[::-1].copy()[::-1], "read-only": read_only(),
    "columns reversed": np.ascontiguousarray(POINTS[:, ::-1])[:, ::-1], "DLPack": Dlpack(POINTS),
    "DLPack, strided": Dlpack(wide("f4")), "DLPack, pinned": Dlpack(POINTS, (3, 0)), "interface": Interface(wide("f8")),
    "memoryview": memoryview(POINTS), "ctypes": CTYPES,
}
WITH_COPY = {
    "lists": POINTS.tolist(), "tuples": tuple(map(tuple, POINTS.tolist())), "list of arrays": list(POINTS),
    "list of float32": list(POINTS.astype("f4")), "big-endian": POINTS.astype(">f8"), "float16": None, "records": records(),
    "misplaced": misplaced(),    "__array__": Frame(), "bytes": memoryview(POINTS.tobytes()).cast("d", shape=[50, 3]),
    "array.array": [array.array("d", row) for row in POINTS.tolist()],
}
WITH_COPY["float16"] = (POINTS * 1024 // 64).astype("f2") * np.float16(1 / 16)


class Inputs(unittest.TestCase):
    def expected(self, points):
        return spherepair.neighbor_list("ijd", np.array(points, float), 0.4, backend="cpu")

    def check(self, given, points=POINTS):
        for ours, theirs in zip(self.expected(points), spherepair.neighbor_list("ijd", given, 0.4, backend="cpu")):
            np.testing.assert_array_equal(ours, theirs)

    def test_positions(self):
        self.assertGreater(len(self.expected(POINTS)[0]), 50)
        for name, given in {**WITHOUT_COPY, **WITH_COPY}.items():
            with self.subTest(kind=name):
                self.check(given, given if name == "float16" else POINTS)

    def test_what_the_library_can_read_is_not_copied(self):
        for name, given in WITHOUT_COPY.items():
            with self.subTest(kind=name):
                view = _inputs.points(given, "positions")
                numbers = np.asarray(getattr(given, "numbers", given))
                self.assertEqual(numbers.__array_interface__["data"][0], view.address)

    def test_what_it_cannot_read_is_copied(self):
        for name in ("records", "misplaced", "big-endian"):
            address = WITH_COPY[name].__array_interface__["data"][0]
            self.assertNotEqual(address, _inputs.points(WITH_COPY[name], "positions").address, name)

    def test_dlpack_with_an_offset_and_other_types(self):
        shape = (ctypes.c_int64 * 2)(50, 3)
        tensor = _dlpack._Tensor(data=POINTS.ctypes.data - 4096, device_type=1, dimensions=2, code=2, bits=64, lanes=1,
                                 shape=shape, byte_offset=4096)
        make = ctypes.pythonapi.PyCapsule_New
        make.restype, make.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
        given = types.SimpleNamespace(__dlpack__=lambda: make(ctypes.addressof(tensor), b"dltensor", None), dtype="bfloat16")
        self.check(given)
        for field, value in (("code", 4), ("bits", 128), ("lanes", 2)):
            before = getattr(tensor, field)
            setattr(tensor, field, value)
            with self.assertRaisesRegex(ValueError, "positions has elements of type bfloat16"):
                self.check(given)
            setattr(tensor, field, before)

    def test_integers_become_float64(self):
        for dtype in ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", ">i4"):
            self.check((POINTS * 8).astype(dtype), np.floor(POINTS * 8))
        self.check((POINTS * 8).astype(int).tolist(), np.floor(POINTS * 8))

    def test_radii(self):
        radii = RANDOM.integers(0, 256, 50) / 1024
        expected = spherepair.collisions(POINTS, radii, backend="cpu")
        self.assertGreater(len(expected), 10)
        for given in (radii.tolist(), radii.astype("f4"), np.repeat(radii, 3)[::3], radii[::-1].copy()[::-1],
                      array.array("d", radii)):
            np.testing.assert_array_equal(expected, spherepair.collisions(POINTS, given, backend="cpu"))
        same = spherepair.neighbor_list("ij", POINTS, 0.25, half=True, backend="cpu")
        for given in (0.125, np.float32(0.125), np.array(0.125)):
            np.testing.assert_array_equal(np.column_stack(same), spherepair.collisions(POINTS, given, backend="cpu"))
        batch = np.arange(50) % 2
        same = np.column_stack(same)
        np.testing.assert_array_equal(same[batch[same[:, 0]] == batch[same[:, 1]]],
                                      spherepair.collisions(POINTS, 0.125, batch=batch, backend="cpu"))

    def test_batches_and_exclusions(self):
        batch = RANDOM.integers(0, 3, 50)
        expected = spherepair.neighbor_list("ij", POINTS, 0.4, batch=batch, exclude=[[0, 1], [2, 3]], backend="cpu")
        for dtype in ("i1", "i4", "u8", ">i8"):
            found = spherepair.neighbor_list("ij", POINTS, 0.4, batch=batch.astype(dtype), backend="cpu",
                                             exclude=np.array([[0, 1], [2, 3]], dtype).T.copy().T)
            np.testing.assert_array_equal(expected, found)
        for nothing in ([], np.empty((0, 2)), np.empty((0, 2), int)):
            spherepair.neighbor_list("ij", POINTS, 0.4, exclude=nothing, backend="cpu")

    def test_cells(self):
        rows = np.array([[2.0, 0, 0], [0.5, 2, 0], [0, 0.25, 2]])
        expected = spherepair.neighbor_list("ijS", POINTS, 0.4, rows, backend="cpu")
        for given in (rows.tolist(), rows.astype("f4"), np.asfortranarray(rows), rows.astype(">f8"), rows[None]):
            for ours, theirs in zip(expected, spherepair.neighbor_list("ijS", POINTS, 0.4, given, backend="cpu")):
                np.testing.assert_array_equal(ours, theirs)
        cube = [spherepair.neighbor_list("ij", POINTS, 0.4, cell, pbc, backend="cpu")
                for cell in ([2, 2, 2], 2 * np.eye(3)) for pbc in (None, True, 1, np.True_, [1, 1, 1], np.ones((1, 3), bool))]
        for found in cube:
            np.testing.assert_array_equal(cube[0], found)


class Outputs(unittest.TestCase):
    def test_types(self):
        for dtype, name in (("int32", "int32"), ("int64", "int64"), (np.int64, "int64"), (np.dtype("i4"), "int32"),
                            (None, None)):
            options = {} if dtype is None else {"index_dtype": dtype}
            i, j, shifts, d, vectors = spherepair.neighbor_list("ijSdD", POINTS, 0.4, [2] * 3, backend="cpu", **options)
            self.assertEqual([name or "int32"] * 3 + ["float64"] * 2, [str(a.dtype) for a in (i, j, shifts, d, vectors)])
            self.assertEqual({(len(i), 3)}, {shifts.shape, vectors.shape})
        self.assertEqual("int64", str(spherepair.radius_graph(POINTS, 0.4, backend="cpu").dtype))

    def test_one_letter_gives_an_array_and_more_a_tuple(self):
        self.assertIsInstance(spherepair.neighbor_list("d", POINTS, 0.4, backend="cpu"), np.ndarray)
        i, again = spherepair.neighbor_list("ii", POINTS, 0.4, backend="cpu")
        np.testing.assert_array_equal(i, again)

    def test_arrays_outlive_the_list_and_the_context(self):
        with spherepair.open("cpu") as context:
            d = spherepair.neighbor_list("ijd", POINTS, 0.4, backend=context)[2]
        kept = d.copy()
        for _ in range(20):
            spherepair.neighbor_list("ijd", -POINTS, 0.41, backend="cpu")
        np.testing.assert_array_equal(kept, d)
        d[:] = 0  # they can be written

    def test_graphs(self):
        line = [[0.0, 0], [1, 0], [9, 0]]
        for x in (line, [0.0, 1, 9], [[0.0], [1], [9]], [[0.0, 0, 0], [1, 0, 0], [9, 0, 0]], np.array(line, "f4")):
            self.assertEqual([[1, 0], [0, 1]], spherepair.radius_graph(x, 2, backend="cpu").tolist())
        edges = spherepair.radius_graph([[0.0, 0], [1, 0], [2.5, 0]], 2, backend="cpu", flow="target_to_source")
        self.assertEqual([[0, 1, 1, 2], [1, 0, 2, 1]], edges.tolist())
        loops = spherepair.radius_graph(line, 2, loop=True, backend="cpu")
        self.assertEqual([[0, 1, 0, 1, 2], [0, 0, 1, 1, 2]], loops.tolist())


if __name__ == "__main__":
    unittest.main()
