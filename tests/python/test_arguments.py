# SPDX-License-Identifier: MIT
"""Wrong arguments: each raises ValueError, and the message names the argument and the place."""

import unittest
from decimal import Decimal
from fractions import Fraction

import numpy as np
from support import CONTEXTS, every_backend, spherepair

POINTS = [[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]
NAN = float("nan")
EYE = np.eye(3)

# arguments beside POINTS and the cutoff 1.5, and what the message has to say
WRONG = [
    (dict(positions=[[0, 0, 0], [1, NAN, 0]]), r"positions\[1\]\.y is nan"),
    (dict(positions=[[0, 0, 0], [1, 0, -np.inf]]), r"positions\[1\]\.z is -inf"),
    (dict(positions=[[0, 0], [1, 0]]), r"positions has shape \(2, 2\): N x 3"),
    (dict(positions=[0, 0, 0]), r"positions has shape \(3,\): N x 3"),
    (dict(positions=[[0, 0, 0], [1, 0]]), r"positions\[1\] has 2 elements, the rows before have 3"),
    (dict(positions=[[0, 0, 0], 7]), r"positions\[1\] is a number"),
    (dict(positions=[[0, 0, 0], [1, "a", 0]]), r"positions\[1\]\[1\] is 'a'"),
    (dict(positions=[[0, 0, 0], [1, None, 0]]), r"positions\[1\]\[1\] is None"),
    (dict(positions=[[0, 0, 0], [1, 2**53 + 1, 0.5]]), r"positions\[1\]\[1\] is 9007199254740993"),
    (dict(positions=[[0, 0, 0], [1, 2**64, 5]]), r"positions\[1\]\[1\] is 18446744073709551616"),
    (dict(positions=np.array([[0, 0, 2**53 + 1]])), r"positions has the integer 9007199254740993"),
    (dict(positions=[[0, 0, 0], [Fraction(1, 3), 0, 0]]), r"positions\[1\]\[0\] is Fraction\(1, 3\)"),
    (dict(positions=[[0, 0, 0], [Decimal("0.1"), 0, 0]]), r"positions\[1\]\[0\] is Decimal"),
    (dict(positions=None), "positions is of type NoneType"),
    (dict(positions="abc"), "positions is of type str"),
    (dict(positions=(p for p in POINTS)), "positions is of type generator"),
    (dict(positions=np.zeros((3, 3), complex)), "positions has elements of type complex128"),
    (dict(positions=np.zeros((3, 3), bool)), "positions has elements of type bool"),
    (dict(positions=np.zeros((3, 3), object)), "positions has elements of type object"),
    (dict(positions=np.zeros((3, 3), np.longdouble)), "positions has elements of type float128"),
    (dict(positions=np.ma.masked_greater(POINTS, 1.5)), "positions has masked elements"),
    (dict(positions=[[1e200, 0, 0]] * 2), r"positions\[0\]\.x is 1e\+200"),
    (dict(cutoff=-1), "cutoff is -1"),
    (dict(cutoff=NAN), "cutoff is nan"),
    (dict(cutoff=np.inf), "cutoff is inf"),
    (dict(cutoff="2"), "cutoff is '2'"),
    (dict(cutoff=None), "neither a cutoff nor radii"),
    (dict(cutoff=[1, 2, 3]), "cutoff is one number for all pairs: give the sizes of spheres as `radii`"),
    (dict(cutoff={("H", "H"): 1}), "cutoff is one number"),
    (dict(cutoff=Fraction(1, 3)), r"cutoff is Fraction\(1, 3\)"),
    (dict(skin=-0.5), "skin is -0.5"),
    (dict(skin=NAN), "skin is nan"),
    (dict(radii=[1, 1, 1]), "there are radii and a cutoff"),
    (dict(cutoff=0, radii=[1, 1]), r"radii has shape \(2,\): one radius for each of 3 points"),
    (dict(cutoff=0, radii=[[1], [1], [1]]), r"radii has shape \(3, 1\)"),
    (dict(cutoff=0, radii=[1, -2, 1]), r"radii\[1\] is -2"),
    (dict(cutoff=0, radii=[1, 1, NAN]), r"radii\[2\] is nan"),
    (dict(cell=np.zeros((3, 3))), r"boxes\[0\]: its periodic rows span no volume"),
    (dict(cell=[[1, 0, 0], [2, 0, 0], [0, 0, 1]]), r"boxes\[0\]: its periodic rows span no volume"),
    (dict(cell=[[1, 0, 0], [0, NAN, 0], [0, 0, 1]]), r"boxes\[0\], row 1, y is nan"),
    (dict(cell=np.eye(2)), r"cell has shape \(2, 2\)"),
    (dict(cell=[1, 2, 3, 90, 90, 90]), r"cell has shape \(6,\)"),
    (dict(cell=5.0), r"cell is of type float"),
    (dict(pbc=True), "pbc is set, but there is no cell"),
    (dict(cell=EYE, pbc=[1, 0]), r"pbc\[0\] is \[1, 0\]: three flags"),
    (dict(cell=EYE, pbc=[1, 0, 2]), r"pbc\[0\] is \[1, 0, 2\]: three flags"),
    (dict(cell=EYE, pbc="TTF"), r"pbc\[0\] is 'T'"),
    (dict(cell=np.array([EYE] * 3), pbc=np.ones((2, 3)), batch=[0, 1, 2]), "cell has 3 boxes, pbc has 2 rows"),
    (dict(cell=np.array([EYE] * 3)), "boxes has 3 rows, but there are 1 systems"),
    (dict(cell=np.array([EYE] * 2), batch=[0, 1, 2]), r"batch\[2\] is 2: systems are 0 to 1"),
    (dict(batch=[0, 0]), r"batch has shape \(2,\): the number of a system for each of 3 points"),
    (dict(batch=[0, -1, 0]), r"batch\[1\] is -1: systems start at 0"),
    (dict(batch=[0, 0.5, 1]), "batch has elements of type f8"),
    (dict(exclude=[[0, 3]]), r"exclusions\[0\] names point 3"),
    (dict(exclude=[[0, 1], [-1, 2]]), r"exclusions\[1\] has the index -1"),
    (dict(exclude=[[0, 1], [7, 2]], batch=[1, 0, 1]), r"exclusions\[1\] names point 7"),
    (dict(exclude=[0, 1, 2]), r"exclude has shape \(3,\): E x 2"),
    (dict(exclude=[[0.0, 1.0]]), "exclude has elements of type f8"),
    (dict(quantities="ijx"), "quantities is 'ijx': one or more of the letters i, j, S, d, D"),
    (dict(quantities=""), "quantities is ''"),
    (dict(quantities=5), "quantities is 5"),
    (dict(index_dtype="int16"), "index_dtype is 'int16': int32 or int64"),
    (dict(index_dtype=np.uint8), "index_dtype is .*uint8"),
]


class OnDevice:
    """An array in the memory of a GPU."""

    def __dlpack_device__(self):
        return 10, 0  # ROCm

    def __dlpack__(self):
        raise AssertionError("not to be called")


class OnCuda:
    __cuda_array_interface__ = {"shape": (3, 3), "typestr": "<f8", "data": (0, False), "version": 3}


class Wrong(unittest.TestCase):
    def complaint(self, message, function, *arguments, **options):
        with self.assertRaisesRegex(ValueError, message):
            function(*arguments, **options)

    @every_backend
    def test_lists(self, context):
        for given, message in WRONG:
            options = {"quantities": "ij", "positions": POINTS, "cutoff": 1.5, **given}
            with self.subTest(message=message):
                self.complaint(message, spherepair.neighbor_list, backend=context, **options)

    def test_the_same_call_without_the_fault(self):
        """The other tests fail for the reason that they name."""
        self.assertEqual([0, 1, 1, 2], spherepair.neighbor_list("i", POINTS, 1.5, backend="cpu").tolist())

    def test_arrays_on_a_device(self):
        complaint, neighbor_list = self.complaint, spherepair.neighbor_list
        complaint("positions is in a device's memory, where it is not read", neighbor_list, "ij", OnDevice(), 1.0)
        complaint("radii is in a device's memory", spherepair.collisions, POINTS, OnCuda(), backend="cpu")
        complaint("positions lies in CUDA's memory, but the context is of cpu", neighbor_list, "ij", OnCuda(), 1.0,
                  backend="cpu")
        complaint("queries are in the host's memory", spherepair.query, OnCuda(), POINTS, 1.0, backend="cpu")
        complaint("radii are in the host's memory", spherepair.collisions, OnCuda(), [1, 1, 1], backend="cpu")
        complaint("cell is in CUDA's memory: copy it", neighbor_list, "ij", POINTS, 1.0, OnCuda(), backend="cpu")
        plan = spherepair.Plan(OnCuda(), 1.0, backend="cpu")
        complaint("give `out`", plan.fill, OnCuda())
        complaint("only torch and cupy allocate", plan.allocate, 5)
        complaint("positions is in the host's memory, but other arrays", plan.fill, POINTS)
        complaint("positions lies in CUDA's memory, but the context is of cpu", plan.count, OnCuda())
        complaint("batch is not sorted", neighbor_list, "ij", OnCuda(), 1.0, batch=[1, 0, 1], backend="cpu")

    def test_queries(self):
        query = spherepair.query
        self.complaint(r"queries has shape \(3,\)", query, POINTS, [0, 0, 0], 1)
        self.complaint(r"queries\[0\]\.z is nan", query, POINTS, [[0, 0, NAN]], 1)
        self.complaint("radii and query_radii go together", query, POINTS, POINTS, radii=[1, 1, 1])
        self.complaint("radii and query_radii go together|neither a cutoff", query, POINTS, POINTS, query_radii=1)
        self.complaint(r"query_radii\[1\] is -1", query, POINTS, POINTS, radii=1, query_radii=[0, -1, 0])
        self.complaint("query_batch is missing", query, POINTS, POINTS, 1, batch=[0, 0, 1])
        self.complaint("batch is missing", query, POINTS, POINTS, 1, query_batch=[0, 0, 1])
        self.complaint(r"exclusions\[0\] names query 3", query, POINTS, POINTS, 1, exclude=[[3, 0]])

    def test_other_functions(self):
        self.complaint("flow is 'up'", spherepair.radius_graph, POINTS, 1, flow="up")
        self.complaint(r"x has shape \(1, 4\)", spherepair.radius_graph, [[0, 0, 0, 0]], 1)
        self.complaint(r"radii\[0\] is -1", spherepair.collisions, POINTS, -1)
        self.complaint("radii is 'big'|radii is of type", spherepair.collisions, POINTS, "big")

    def test_places_are_those_of_the_caller(self):
        """A batch that is not sorted is sorted for the library: its messages still name the caller's point."""
        points = np.zeros((4, 3))
        points[2, 1] = NAN
        self.complaint(r"positions\[2\]\.y is nan", spherepair.neighbor_list, "i", points, 1, batch=[1, 0, 0, 1])
        self.complaint(r"radii\[3\] is -1", spherepair.neighbor_list, "i", np.zeros((4, 3)), radii=[0, 0, 0, -1.0],
                       batch=[2, 1, 1, 0])

    def test_backends(self):
        for name in ("metal", ""):
            with self.assertRaisesRegex((ValueError, spherepair.BackendError), "backend|metal"):
                spherepair.neighbor_list("i", POINTS, 1, backend=name)
        with self.assertRaisesRegex(ValueError, "threads is -1"):
            spherepair.open("cpu", threads=-1)
        self.assertIn("cpu", CONTEXTS)


if __name__ == "__main__":
    unittest.main()
