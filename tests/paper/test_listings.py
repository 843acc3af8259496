# SPDX-License-Identifier: MIT
"""paper/listings finds the hot loop of a kernel in its machine code, and the code of OpenGL's kernels in the driver's cache."""
import ctypes
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

import stand_ins  # noqa: E402  (the path must be set first)
from paper.machine import machine_code, sass, shader_cache  # noqa: E402
from paper.tools import Failed  # noqa: E402


def code_of(*lines):
    """Instructions, 16 bytes each; a line `name:` is a label."""
    text, address = "", 0
    for line in lines:
        if line.endswith(":"):
            text += f".L_x_{line}\n"
        else:
            text += f"        /*{address:04x}*/                   {line} ;     /* 0x00000a00ff017b82 */\n"
            address += 16
    return sass.parse(text)


def shown(loop):
    return [one.text for one in loop.way]


class Loops(unittest.TestCase):
    def test_counts_and_listing_are_of_the_shortest_way_round(self):
        loop = sass.hot_loop(sass.parse(stand_ins.LOOP))
        counts = loop.counts()
        self.assertEqual((6, 8), (counts["instructions"], counts["of_whole_loop"]))
        self.assertEqual({"float": 1, "compare": 2, "shared": 1, "global": 0, "constant": 0, "control": 2, "integer": 0},
                         counts["by_class"])
        self.assertEqual({"FSETP": 2, "BRA": 2, "LDS": 1, "FADD": 1}, counts["by_opcode"])
        self.assertIn("| 00050  @P0 BRA 0x80\n  00060  FADD R13, R5, -R21\n", loop.listing())

    def test_the_innermost_loop_with_most_floats_is_taken(self):
        code = code_of("1:", "FADD R0, R0, R1", "FADD R0, R0, R2", "FADD R0, R0, R3", "FADD R0, R0, R3",
                       "2:", "FFMA R0, R1, R2, R0", "FFMA R4, R1, R2, R4", "@P0 BRA `(.L_x_2)",
                       "3:", "IADD3 R5, R5, 0x1, RZ", "FMUL R0, R0, R0", "@P1 BRA `(.L_x_3)",
                       "@P2 BRA `(.L_x_1)", "EXIT")
        self.assertEqual(["FFMA R0, R1, R2, R0", "FFMA R4, R1, R2, R4", "@P0 BRA `(.L_x_2)"], shown(sass.hot_loop(code)))

    def test_a_rare_part_behind_the_end_belongs_to_its_loop(self):
        """Its jump back is none of a loop of its own, though it goes to a lower address."""
        code = code_of("1:", "FADD R0, R0, R1", "@P0 BRA `(.L_x_3)", "2:", "@P1 BRA `(.L_x_1)", "EXIT",
                       "3:", "FMUL R2, R0, R0", "FMUL R2, R0, R0", "BRA `(.L_x_2)", "4:", "BRA `(.L_x_4)")
        loop = sass.hot_loop(code)
        self.assertEqual(["FADD R0, R0, R1", "@P0 BRA `(.L_x_3)", "@P1 BRA `(.L_x_1)"], shown(loop))
        self.assertEqual(6, len(loop.whole))

    def test_a_loop_that_is_entered_in_its_middle_is_one(self):
        code = code_of("MOV R1, R2", "BRA `(.L_x_2)", "1:", "FMUL R2, R0, R0", "2:", "FADD R0, R0, R1", "@P0 BRA `(.L_x_1)",
                       "EXIT")
        self.assertEqual(["FADD R0, R0, R1", "@P0 BRA `(.L_x_1)", "FMUL R2, R0, R0"], shown(sass.hot_loop(code)))

    def test_where_ways_join_there_is_no_loop(self):
        self.assertIsNone(sass.hot_loop(code_of("@P0 BRA `(.L_x_1)", "FADD R0, R0, R1", "1:", "FADD R0, R0, R1", "EXIT")))

    def test_branches_by_an_operand_may_fall_through(self):
        code = code_of("1:", "FADD R0, R0, R1", "BRA.U UP0, `(.L_x_1)", "2:", "FADD R0, R0, R1", "FADD R0, R0, R1",
                       "BRA P0, 0x20", "@!PT EXIT", "EXIT")
        self.assertEqual(3, len(sass.hot_loop(code).way))

    def test_a_loop_that_is_called(self):
        """As OpenGL's compiler places the loop of collide_grid, which ends in a jump back to the caller's."""
        code = code_of("1:", "IADD3 R1, R1, 0x1, RZ", "@P0 CALL.REL.NOINC `(.L_x_2)", "BRA `(.L_x_1)", "EXIT",
                       "2:", "FADD R0, R0, R1", "@P1 BRA `(.L_x_2)", "BRA `(.L_x_1)")
        self.assertEqual(["FADD R0, R0, R1", "@P1 BRA `(.L_x_2)"], shown(sass.hot_loop(code)))

    def test_where_there_is_no_loop_there_is_none(self):
        self.assertIsNone(sass.hot_loop([]))
        self.assertIsNone(sass.hot_loop(code_of("FADD R0, R0, R1", "1:", "IADD3 R1, R1, R2, RZ", "@P0 BRA `(.L_x_1)", "EXIT")))

    def test_registers(self):
        self.assertEqual(256, sass.registers_named(code_of("FADD R0, R255, RZ", "UMOV UR300, 0x1")))


def frame(content):
    """A zstd frame."""
    library, room = shader_cache.zstd_library(), len(content) + 1024
    library.ZSTD_compress.restype = ctypes.c_size_t
    held = ctypes.create_string_buffer(room)
    made = library.ZSTD_compress(held, ctypes.c_size_t(room), content, ctypes.c_size_t(len(content)), 3)
    return held.raw[:made]


def container(code):
    """An entry of kind 3 comes first, and something else behind the code."""
    entries = ((3, 8, 0x40), (1, len(code), 0x60))
    return b"NVuc".ljust(32) + b"".join(struct.pack("<IIQ", *entry).ljust(32, b"\0") for entry in entries) + code + b"behind"


class Cache(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_programs_in_frames_are_found_each_once(self):
        first, second = frame(b"head" + container(b"one") + container(b"two")), frame(container(bytes(100000)))
        (self.folder / "deep").mkdir()
        (self.folder / "deep/a.bin").write_bytes(b"index" + first + b"between" + shader_cache.FRAME + b"no frame" + second)
        (self.folder / "b.bin").write_bytes(frame(container(b"one")) + frame(b"no program"))
        (self.folder / "c.bin").write_bytes(container(b"not compressed"))
        found = shader_cache.programs(self.folder)
        self.assertEqual({b"one", b"two", bytes(100000), b"not compressed"}, {code for _, code in found})
        self.assertEqual(4, len(found))

    def test_a_command_that_leaves_none_is_named(self):
        with self.assertRaisesRegex(Failed, "none of the 1 files that .* left"):
            shader_cache.compiled_by([sys.executable, "-c", "import os; open(os.environ['__GL_SHADER_DISK_CACHE_PATH'] + '/a', 'w')"])
        with self.assertRaisesRegex(Failed, "failed with exit code 3"):
            shader_cache.compiled_by([sys.executable, "-c", "raise SystemExit(3)"])


    def test_a_container_without_code_is_no_program(self):
        self.assertEqual(b"", shader_cache.code_of(b"NVuc".ljust(96, b"\3")))
        self.assertEqual(b"", shader_cache.code_of(container(b"code")[:0x60]))


PROGRAM = """#!{python}
import json, os, pathlib, sys
words = sys.argv[1:]
if words[0] == "devices":
    record = {{"context": {{"sources": {{}}}}, "backends": [{{"name": "cuda", "open": {open}, "details": {{"compute capability": "9.0"}}}}]}}
    pathlib.Path(words[words.index("--json") + 1]).write_text(json.dumps(record))
else:
    pathlib.Path(os.environ["__GL_SHADER_DISK_CACHE_PATH"], "a").write_bytes(
        b"NVuc".ljust(32) + b"\\1\\0\\0\\0\\x20\\0\\0\\0\\x40".ljust(32, b"\\0") + bytes(32))
"""


class Script(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = pathlib.Path(folder.name)
        self.environment = stand_ins.make_tools(self.home)
        self.program()

    def program(self, is_open=True):
        path = self.home / "program"
        path.write_text(PROGRAM.format(python=sys.executable, open=is_open))
        path.chmod(0o755)

    def listed(self, code=0):
        made = subprocess.run([ROOT / "paper/listings", self.home / "machine", "--program", self.home / "program"],
                              env=self.environment, capture_output=True, text=True)
        self.assertEqual(code, made.returncode, made.stderr)
        return made.stdout + made.stderr

    def test_it_records_each_kernel_in_both_apis(self):
        self.assertRegex(self.listed(), r"collide_grid +cuda +6 +2 +3\.00 +22")
        folder = self.home / "machine/listings"
        record = json.loads((folder / "listings.json").read_text())
        self.assertEqual(6, len(record["listings"]))
        self.assertEqual({entry["file"] for entry in record["listings"]} | {"listings.json"}, set(os.listdir(folder)))
        by_api = {entry["backend"]: entry for entry in record["listings"] if entry["kernel"] == "collide_grid"}
        self.assertEqual((None, 41), (by_api["opengl"]["registers"], by_api["cuda"]["registers"]))
        self.assertIn("collide_gridILi128ELb1ELb0E", by_api["cuda"]["name"])
        self.assertIn("6 instructions for 2 pairs.\n\n| 00010  LDS", (folder / "collide_grid-cuda.txt").read_text())
        triangle = next(entry for entry in record["listings"] if entry["kernel"] == "collide_triangle")
        self.assertIsNone(triangle["pairs"])  # no FFMA there

    def test_without_cuda_or_a_tool_nothing_is_left(self):
        self.program(is_open=False)
        self.assertIn("cuda is not open", self.listed(code=1))
        self.program()
        (self.home / "nvdisasm").unlink()
        self.environment |= {"PATH": "/nowhere", "CUDA_PATH": "/nowhere"}
        made = subprocess.run([sys.executable, ROOT / "paper/listings", self.home / "machine", "--program", self.home / "program"],
                              env=self.environment, capture_output=True, text=True)
        self.assertRegex(made.stderr, "^listings: nvdisasm is neither in PATH nor in /nowhere/bin")
        self.assertFalse((self.home / "machine").exists())


if __name__ == "__main__":
    unittest.main()
