# SPDX-License-Identifier: MIT
"""Plans for positions in CUDA's memory. A stand-in for the GPU checks which arrays, stream and rows reach the library."""

import ctypes
import unittest
from unittest import mock

import numpy as np
from support import Case, spherepair

from spherepair import _abi, _plan

POINTS = np.random.default_rng(3).uniform(0, 4, (60, 3))
COLUMNS = ("first", "second", "shifts", "vectors", "distances", "offsets")


class OnCuda:
    """Memory of the host that says it is CUDA's."""

    def __init__(self, numbers, stream=None):
        self.numbers, self.shape = numbers, numbers.shape
        self.__cuda_array_interface__ = {**numbers.__array_interface__, "stream": stream}

    def __getitem__(self, rows):
        return self.numbers[rows]


class OnlyDlpack:
    """The same by DLPack alone."""

    def __init__(self, numbers):
        self.numbers = numbers

    def __dlpack_device__(self):
        return 2, 0

    def __dlpack__(self, stream):
        assert stream == 1
        return self.numbers.__dlpack__()


class StandIn:
    """sp_fill as a GPU does it: the first call waits, later ones leave count at -1 and the number in `found`."""

    def __init__(self, real):
        self.real, self.calls, self.fault = real, [], None

    def __call__(self, handle, problem, pairs):
        problem, pairs = problem._obj, pairs._obj
        on_host = _abi.Problem.from_buffer_copy(problem)
        columns = _abi.Pairs.from_buffer_copy(pairs)
        self.calls.append({"stream": problem.stream, "positions": problem.positions.data,
                           **{name: getattr(pairs, name).data for name in (*COLUMNS, "found")}})
        for array in (on_host.positions, *(getattr(columns, name) for name in COLUMNS)):
            assert not array.data or array.device_type == _abi.CUDA
            array.device_type = _abi.HOST
        columns.found = _abi.Array()
        status = self.real(handle, ctypes.byref(on_host), ctypes.byref(columns))
        pairs.count = columns.count
        if pairs.found.data:
            ctypes.c_int64.from_address(pairs.found.data).value = columns.count if self.fault is None else self.fault
            if len(self.calls) > 1:
                pairs.count, status = -1, _abi.OK
        return status


StandIn.restype = ctypes.c_int32  # as _call asks


class PlansOnCuda(Case):
    def setUp(self):
        self.stand_in = StandIn(_plan.lib.sp_fill)
        patch = mock.patch.object(_plan, "lib", mock.Mock(wraps=_plan.lib, sp_fill=self.stand_in))
        patch.start()
        self.addCleanup(patch.stop)

    def plan_and_columns(self, rows, **options):
        plan = spherepair.Plan(OnCuda(POINTS), 0.9, quantities="ijd", backend="cpu", **options)
        columns = {"i": np.zeros(rows, "i4"), "j": np.zeros(rows, "i4"), "d": np.zeros(rows), "offsets": np.zeros(61, "i8"),
                   "found": np.zeros(1, "i8")}
        return plan, columns, plan.into(**{name: OnCuda(column) for name, column in columns.items()})

    def test_the_callers_columns_are_filled_in_the_callers_stream(self):
        plan, columns, out = self.plan_and_columns(2000)
        for step, stream in enumerate((None, 2, 77)):
            x = POINTS + 0.1 * step
            self.assertIs(out, plan.fill(OnCuda(x, stream), out))
            call = self.stand_in.calls[-1]
            self.assertEqual((stream, x.ctypes.data), (call["stream"], call["positions"]))
            for name, field in (("i", "first"), ("j", "second"), ("d", "distances"), ("offsets", "offsets"), ("found", "found")):
                self.assertEqual(columns[name].ctypes.data, call[field])
            self.assertIsNone(call["shifts"])
            expected = spherepair.neighbor_list("ijd", x, 0.9, backend="cpu")
            self.assertEqual((len(expected[0]), False), (out.found, out.overflowed))
            for name, column in zip("ijd", expected):
                np.testing.assert_array_equal(column, getattr(out, name))
            self.assertIs(out.columns["i"].numbers, columns["i"])

    def test_too_little_room_is_known_when_found_is_read(self):
        plan, columns, out = self.plan_and_columns(10)
        needed = len(spherepair.neighbor_list("i", POINTS, 0.9, backend="cpu"))
        for _ in range(2):
            plan.fill(OnCuda(POINTS), out)
            self.assertEqual((needed, 10, True), (out.found, out.capacity, out.overflowed))
            with self.assertRaises(spherepair.CapacityError) as caught:
                out.i
            self.assertEqual((needed, 10), (caught.exception.needed, caught.exception.given))
        columns["found"][0] = 3  # a replayed graph has written it
        self.assertEqual((3, False, 3), (out.found, out.overflowed, len(out.j)))

    def test_numbers_that_cannot_be_listed(self):
        plan, _, out = self.plan_and_columns(2000)
        for fault, message in ((-18, r"positions\[17\] cannot be listed"), (-2**63, "spans too many boxes")):
            self.stand_in.fault = fault
            with self.assertRaisesRegex(ValueError, message):
                plan.fill(OnCuda(POINTS), out).found

    def test_without_found_the_count_is_the_calls(self):
        plan, columns, _ = self.plan_and_columns(2000)
        out = plan.into(**{name: OnCuda(columns[name]) for name in "ijd"})
        self.assertEqual(len(spherepair.neighbor_list("i", POINTS, 0.9, backend="cpu")), plan.fill(OnCuda(POINTS), out).found)

    def test_arrays_by_dlpack_alone(self):
        plan = spherepair.Plan(OnlyDlpack(POINTS), 0.9, quantities="i", backend="cpu")
        column = np.zeros(2000, "i4")
        out = plan.fill(OnlyDlpack(POINTS), plan.into(i=OnlyDlpack(column)))
        self.assertEqual((POINTS.ctypes.data, column.ctypes.data, None),
                         tuple(self.stand_in.calls[0][name] for name in ("positions", "first", "stream")))
        np.testing.assert_array_equal(spherepair.neighbor_list("i", POINTS, 0.9, backend="cpu"), column[:out.found])

    def test_a_plan_has_a_context_of_its_own(self):
        self.assertIsNot(self.plan_and_columns(1)[0].context, self.plan_and_columns(1)[0].context)

    def test_faults(self):
        plan, columns, out = self.plan_and_columns(10)
        given = {name: OnCuda(columns[name]) for name in "ijd"}
        fewer = spherepair.Plan(OnCuda(POINTS[:9]), 0.9, quantities="ijd", backend="cpu")
        for message, call in (("the columns are i, j: give i, j, d, and if you like found or offsets",
                               lambda: plan.into(i=given["i"], j=given["j"])),
                              ("the columns are i, j, d, S", lambda: plan.into(**given, S=given["i"])),
                              ("j is in the host's memory", lambda: plan.into(**{**given, "j": columns["j"]})),
                              ("j has elements of type u4: give int64 or int32 or float64",
                               lambda: plan.into(**{**given, "j": OnCuda(columns["j"].view("u4"))})),
                              ("out is for 60 points, the plan for 9", lambda: fewer.fill(OnCuda(POINTS[:9]), out)),
                              ("positions has 9 rows", lambda: plan.fill(OnCuda(POINTS[:9]), out)),
                              ("capacity is -1", lambda: plan.allocate(-1))):
            with self.subTest(message=message), self.assertRaisesRegex(ValueError, message):
                call()


if __name__ == "__main__":
    unittest.main()
