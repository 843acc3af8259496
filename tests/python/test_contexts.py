# SPDX-License-Identifier: MIT
"""Contexts: opening, closing, threads, processes. Errors that are not the arguments'. Loading the library."""

import gc
import os
import pathlib
import pickle
import subprocess
import sys
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from unittest import mock

import numpy as np
from support import CONTEXTS, MISSING, ROOT, every_backend, spherepair

from spherepair import _abi, _context, _errors, _library

POINTS = np.random.default_rng(1).uniform(0, 6, (500, 3))


def bits(context):
    return [column.tobytes() for column in spherepair.neighbor_list("ijSdD", POINTS, 0.8, [6] * 3, backend=context)]


class Contexts(unittest.TestCase):
    def test_names_and_devices(self):
        for name, context in CONTEXTS.items():
            self.assertEqual(name, context.backend)
            self.assertTrue(context.device)
            self.assertIn(name, repr(context))
        self.assertIn(spherepair.open("auto").backend, CONTEXTS)

    def test_missing_backends_say_why(self):
        for name in set(MISSING) - set(CONTEXTS):
            with self.assertRaises(spherepair.BackendError) as caught:
                spherepair.neighbor_list("i", POINTS, 1, backend=name)
            self.assertEqual(MISSING[name], caught.exception.reason)

    def test_a_device_that_is_not_there(self):
        with self.assertRaises(ValueError):
            spherepair.open("cpu", device=1)
        for name in set(CONTEXTS) - {"cpu"}:
            with self.assertRaises((spherepair.BackendError, ValueError), msg=name):
                spherepair.open(name, device=7777)

    @every_backend
    def test_closing(self, context):
        with spherepair.open(context.backend) as other:
            expected = bits(other)
        other.close()
        self.assertIn("closed", repr(other))
        with self.assertRaisesRegex(spherepair.BackendError, "the context is closed"):
            bits(other)
        self.assertEqual(expected, bits(context))

    def test_contexts_are_kept_for_a_thread(self):
        kept = _context.context_of("cpu")
        self.assertIs(kept, _context.context_of("cpu"))
        with ThreadPoolExecutor(1) as pool:
            self.assertIsNot(kept, pool.submit(_context.context_of, "cpu").result())

    @every_backend
    def test_many_threads(self, context):
        """One context for all, and one each: calls run at once or wait, and give the same bits."""
        expected = bits(context)
        for backend in (context, context.backend):
            with ThreadPoolExecutor(4) as pool:
                for found in pool.map(lambda _: bits(backend), range(12)):
                    self.assertEqual(expected, found)

    @every_backend
    def test_errors_of_threads_stay_apart(self, context):
        """Each thread gets the message of its own call though they share a context."""
        def complain(k):
            points = np.zeros((20, 3))
            points[k, k % 3] = np.nan
            try:
                spherepair.neighbor_list("i", points, 1, backend=context)
            except ValueError as error:
                return str(error)
        with ThreadPoolExecutor(4) as pool:
            for k, message in enumerate(pool.map(complain, range(20))):
                self.assertIn(f"positions[{k}].{'xyz'[k % 3]} is nan", message)

    def test_a_context_is_closed_with_its_last_reference(self):
        with mock.patch.object(_context, "lib", wraps=_context.lib) as library:
            context = spherepair.open("cpu")
            del context
            gc.collect()
            self.assertEqual(1, library.sp_close.call_count)

    @unittest.skipUnless(hasattr(os, "fork"), "there is no os.fork()")
    def test_a_context_does_not_survive_a_fork(self):
        code = ("import os, spherepair as s\n"
                "c = s.open('cpu', threads=1); x = [[0, 0, 0], [1, 0, 0]]; n = len(s.neighbor_list('i', x, 2, backend=c))\n"
                "if os.fork() == 0:\n"
                "  try: s.neighbor_list('i', x, 2, backend=c)\n"
                "  except s.BackendError as e: print('child:', e, flush=True)\n"
                "  c.close(); os._exit(0)\n"
                "os.wait(); print('parent:', n, len(s.neighbor_list('i', x, 2, backend=c)))")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT / "python", timeout=15)
        self.assertEqual("child: the context was opened before os.fork(): open another one in this process\n"
                         "parent: 2 2\n", run.stdout, run.stderr)

    @unittest.skipUnless(hasattr(os, "fork"), "there is no os.fork()")
    def test_a_child_process_has_threads_of_its_own(self):
        """The CPU's threads end before a fork: otherwise the child waits for them forever."""
        code = ("import multiprocessing, random, spherepair as s\n"
                "x = [[random.random() for _ in range(3)] for _ in range(20000)]\n"
                "def count(k): return len(s.neighbor_list('i', x, 0.05, backend='cpu'))\n"
                "first = count(0)\n"
                "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
                "  print([first] * 2 == pool.map_async(count, range(2)).get(10), first == count(0) > 0)")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT / "python", timeout=15)
        self.assertEqual("True True\n", run.stdout, run.stderr)

    def test_a_thread_in_a_call_does_not_hold_up_the_end(self):
        code = ("import threading, time, spherepair as s, random\n"
                "x = [[random.random() for _ in range(3)] for _ in range(3000)]\n"
                "def run():\n"
                "  while True: s.neighbor_list('i', x, 0.5, backend='cpu')\n"
                "threading.Thread(target=run, daemon=True).start(); time.sleep(0.3)")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT / "python", timeout=15)
        self.assertEqual((0, ""), (run.returncode, run.stderr))
        self.assertFalse(CONTEXTS["cpu"]._closer.atexit)


class Errors(unittest.TestCase):
    def test_kinds(self):
        for status, kind in ((_abi.ARGUMENT, ValueError), (_abi.NONFINITE, ValueError), (_abi.RANGE, ValueError),
                             (_abi.MEMORY, MemoryError), (_abi.BACKEND, spherepair.BackendError)):
            self.assertIs(kind, type(_errors.error(status, "why")))
        self.assertEqual("why", _errors.error(_abi.BACKEND, "why").reason)

    def test_errors_can_be_sent_to_another_process(self):
        error = pickle.loads(pickle.dumps(spherepair.CapacityError(9, 4)))
        self.assertEqual((9, 4), (error.needed, error.given))
        self.assertEqual("no driver", pickle.loads(pickle.dumps(spherepair.BackendError("no driver"))).reason)


class Library(unittest.TestCase):
    def import_it(self, **environment):
        run = subprocess.run([sys.executable, "-c", "import spherepair; print(spherepair.__version__)"],
                             capture_output=True, text=True, cwd=ROOT / "python", env={**os.environ, **environment})
        return run.stdout.strip(), run.stderr.strip().rpartition("\n")[2]

    def test_the_version_is_the_librarys(self):
        self.assertRegex(self.import_it()[0], r"^\d+\.\d+\.\d+$")

    def test_a_path_that_is_wrong(self):
        _, message = self.import_it(SPHEREPAIR_LIBRARY="/nowhere/libspherepair.so")
        self.assertRegex(message, "ImportError: spherepair's library cannot be loaded: /nowhere/libspherepair.so: .*"
                                  "set SPHEREPAIR_LIBRARY to the path of libspherepair.so")

    def test_another_library(self):
        path = next(line.split()[-1] for line in pathlib.Path("/proc/self/maps").read_text().splitlines()
                    if "libc.so" in line)
        self.assertRegex(self.import_it(SPHEREPAIR_LIBRARY=path)[1], "ImportError: .* is not spherepair's library")

    def test_another_abi(self):
        with mock.patch.object(_abi, "ABI_VERSION", 7), self.assertRaisesRegex(
                ImportError, "has version 2 of the ABI, this package needs 7"):
            _library.load(_library._candidates()[0])

    def test_structs_have_the_librarys_sizes(self):
        """The library compares the sizes itself: a problem of another size is refused."""
        problem = _abi.Problem(size=8)
        with self.assertRaisesRegex(ValueError, r"problem\.size is 8, but sizeof\(sp_problem\) is "
                                                + str(len(bytes(problem)))):
            _context.context_of("cpu")._call(_context.lib.sp_count, problem, _abi.c_int64())

    def test_the_main_thread_is_not_needed(self):
        results = []
        thread = threading.Thread(target=lambda: results.append(bits("cpu")))
        thread.start()
        thread.join()
        self.assertEqual([bits("cpu")], results)


if __name__ == "__main__":
    unittest.main()
