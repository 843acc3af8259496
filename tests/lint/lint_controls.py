# SPDX-License-Identifier: MIT
"""Negative controls: every rule of the lint must complain when it is broken.

Usage: lint_controls.py BUILD [options of unittest]"""

import pathlib
import sys
import tempfile
import unittest

import lint_arithmetic
import lint_kernels
import lint_rooms
import lint_sources
from lint_controls_twins import Twins, tree  # noqa: F401 - unittest finds them here

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else ROOT / "build"
HEAD = "#version 450\nlayout(local_size_x = 64) in;\nlayout(std430, binding = 0) buffer Data { float x[]; };\n"


class Sources(unittest.TestCase):
    def complaints(self, rule, **texts):
        with tempfile.TemporaryDirectory() as folder:
            return rule(tree(folder, **texts), None)[0]

    def test_files(self):
        spdx = "// SPDX-License-Identifier: MIT\n"
        self.assertEqual([], self.complaints(lint_sources.files, common__a_DOT_h=spdx + "\n" * 249))
        self.assertEqual(1, len(self.complaints(lint_sources.files, common__a_DOT_h=spdx + "\n" * 250)))
        self.assertEqual(1, len(self.complaints(lint_sources.files, common__a_DOT_h="int a;\n")))

    def test_headers(self):
        comp, guard = '#include "a.h"\n', "#ifndef A\n#define A\n"
        def check(text):
            return self.complaints(lint_sources.headers, shaders__k_DOT_comp=comp, common__shared__a_DOT_h=text)
        self.assertEqual([], check(guard + "#endif\n"))
        self.assertEqual(1, len(check(guard + "#ifdef __CUDACC__\n#endif\n#endif\n")))
        self.assertEqual(1, len(check("#if 1\n#endif\n")))
        for foreign in ("<cuda_runtime.h>", "<thrust/sort.h>", "<epoxy/gl.h>", '"EGL/egl.h"', "<cub/cub.cuh>"):
            self.assertEqual(1, len(check(f"{guard}#include {foreign}\n#endif\n")), foreign)

    def test_borders(self):
        asking = "#ifdef SPHEREPAIR_WITH_CUDA\n"
        self.assertEqual(1, len(self.complaints(lint_sources.borders, bench__b_DOT_cpp=asking)))
        self.assertEqual([], self.complaints(lint_sources.borders, api__open_DOT_cpp=asking))

    def test_rooms(self):
        def check(arrows="bench -> glsl\nglsl\n", links="add_room(glsl fmt::fmt)", **texts):
            texts = {"bench__b_DOT_h": "", "glsl__g_DOT_h": "", **texts}
            return self.complaints(lint_rooms.rooms, docs__ARCHITECTURE_DOT_md=f"```rooms\n{arrows}```\n",
                                   CMakeLists_DOT_txt=links, **texts)
        self.assertEqual([], check(bench__c_DOT_h='#include "glsl/g.h"\n'))
        self.assertEqual(1, len(check(glsl__h_DOT_h='#include "bench/b.h"\n')))
        self.assertEqual(1, len(check(bench__c_DOT_h='#include "b.h"\n')))
        self.assertEqual(1, len(check(links="add_room(glsl bench)")))
        self.assertEqual(1, len(check(arrows="bench -> glsl\nglsl -> bench\n")))
        self.assertEqual(1, len(check(bench__more__b_DOT_h="")))
        self.assertEqual(1, len(check(arrows="bench\nglsl\ncuda\n")))
        many = {f"glsl__g{k}_DOT_h": "" for k in range(lint_rooms.MOST_FILES)}
        self.assertEqual(1, len(check(**many)))

    def test_functions(self):
        def check(lines):
            body = "  a = 1;\n" * (lines - 2)
            return len(self.complaints(lint_sources.functions, bench__a_DOT_cpp=f"int f(int a) {{\n{body}}}\n"))
        self.assertEqual([0, 1], [check(lint_sources.MAX_FUNCTION), check(lint_sources.MAX_FUNCTION + 1)])

    def test_mutants(self):
        def check(text, suite="Draw"):
            listed = f'MUTANTS = [{{"name": "n", "file": "common/a.h", "old": {text!r}, "tests": ["{suite}"]}}]\n'
            return len(self.complaints(lint_sources.mutants, common__a_DOT_h="int a;\nint b;\n",
                                       tests__unit__test_a_DOT_cpp="TEST_F(DrawLight, IsRight) {\n",
                                       tests__lint__CMakeLists_DOT_txt="foreach(name numbers sources)\n",
                                       tests__mutants__mutant_list_DOT_py=listed))
        self.assertEqual([0, 1, 1, 1], [check("int a"), check("int "), check("float"), check("int a", "DrawLights")])
        self.assertEqual([0, 1], [check("int a", "paper.sources"), check("int a", "paper.none")])

    def test_builtins(self):
        def check(text):
            return len(self.complaints(lint_sources.builtins, shaders__a_DOT_comp=text))
        for name in ("dot", "length", "normalize", "mix", "inversesqrt", "floor", "fma"):
            self.assertEqual(1, check(f"a = {name}(b);"), name)
        self.assertEqual(0, check("n = data.length(); // mix(a)\nremix(b);"))

    def test_formatting(self):
        try:
            lint_sources.clang_format()
        except lint_sources.Skip as reason:
            self.skipTest(str(reason))
        self.assertEqual([], self.complaints(lint_sources.formatting, common__a_DOT_h="int a;\n"))
        self.assertEqual(1, len(self.complaints(lint_sources.formatting, common__a_DOT_h="int  a;\n")))


class Shaders(unittest.TestCase):
    def assemblies(self, *texts):
        try:
            return list(lint_arithmetic.disassembled(texts, BUILD))
        except lint_sources.Skip as reason:
            self.skipTest(str(reason))

    def complaints(self, body, may_fuse=True):
        assembly, = self.assemblies(HEAD + f"void main() {{ {body} }}")
        return lint_arithmetic.spirv_complaints(assembly, may_fuse)

    def test_contraction(self):
        self.assertEqual([], self.complaints("precise float a = x[0] * x[1] + x[2]; x[3] = a;"))
        self.assertEqual(2, len(self.complaints("float a = x[0] * x[1] + x[2]; x[3] = a;")))
        self.assertTrue(self.complaints("vec3 a = vec3(x[0]) * x[1]; x[3] = a.x;"))

    def test_functions(self):
        self.assertEqual([], self.complaints("precise float a = fma(x[0], x[1], x[2]); x[3] = a;"))
        self.assertEqual(1, len(self.complaints("precise float a = fma(x[0], x[1], x[2]); x[3] = a;", may_fuse=False)))
        for call in ("sqrt(x[0])", "inversesqrt(x[0])", "mix(x[0], x[1], x[2])", "floor(x[0])", "length(vec2(x[0]))",
                     "dot(vec2(x[0]), vec2(x[1]))"):
            self.assertTrue(self.complaints(f"precise float a = {call}; x[3] = a;"), call)

    def test_motion_without_precise(self):
        path = BUILD / "flattened" / "move.comp"
        if not path.exists():
            self.skipTest("the build has no GLSL")
        programs = lint_arithmetic.variants("move", path.read_text())
        loose = [lint_arithmetic.with_defines(path.read_text(), *defines).replace("#define EXACT precise", "#define EXACT")
                 for defines in programs]
        for defines, assembly in zip(programs, self.assemblies(*loose)):
            self.assertTrue(lint_arithmetic.spirv_complaints(assembly, False), defines)

    def test_uses(self):
        blocks = "".join(f"layout(std430, binding = {k}) buffer B{k} {{ uint b[]; }} b{k}; " for k in (0, 1, 2))
        array = "layout(std430, binding = 4) buffer B4 { int b[]; } b4[3]; "
        body = "void main() { b1.b[0] = b0.b[2]; atomicAdd(b2.b[0], 1u); b4[1].b[0] = 2; }"
        assembly, = self.assemblies("#version 450\n" + blocks + array + body)
        self.assertEqual(({0, 2}, {1, 2, 4, 5, 6}), lint_kernels.used_slots(assembly))
        said = list(lint_kernels.complaints(ROOT, "tally", [({2, 3}, {3}), ({3, 0}, set())]))
        self.assertEqual(["tally: reads position, which common/device/kernel_list.h does not say"], said)
        said = list(lint_kernels.complaints(ROOT, "tally", [({2, 3}, set())]))
        self.assertEqual(["tally: never writes summary, as common/device/kernel_list.h says"], said)

    def test_broken_shader(self):
        broken, right = self.assemblies(HEAD + "void main() { x[0] = undeclared; }", HEAD + "void main() { x[0] = 1.0; }")
        self.assertIn("undeclared", str(broken))
        self.assertIn("OpStore", right)


class Cuda(unittest.TestCase):
    def test_ptx(self):
        exact = ("\tadd.rn.f32 %f3, %f1, %f2;\n\tmul.rn.f64 %d1, %d2, %d3;\n"
                 "\tmad.lo.s32 %r1, %r2, %r3, %r4;\n\tmul.wide.u32 %d, %r, 4;\n")
        self.assertEqual([], lint_arithmetic.ptx_complaints(exact))
        for line in ("fma.rn.f32 %f1, %f2, %f3, %f4;", "fma.rn.ftz.f32 %f1, %f2, %f3, %f4;",
                     "mad.rn.f64 %d1, %d2, %d3, %d4;", "mul.f32 %f1, %f2, %f3;", "add.ftz.f32 %f1, %f2, %f3;",
                     "div.approx.f32 %f1, %f2, %f3;"):
            self.assertEqual(1, len(lint_arithmetic.ptx_complaints(f"\t{line}\n")), line)
            fused_by_name = line.startswith("fma.rn.f32")
            self.assertEqual(not fused_by_name, bool(lint_arithmetic.ptx_complaints(f"\t{line}\n", with_search=True)), line)

    def test_motion_with_fmad(self):
        try:
            commands = lint_arithmetic.kernel_commands(ROOT, BUILD)
        except lint_sources.Skip as reason:
            self.skipTest(str(reason))
        loose = lint_arithmetic.ptx_of(commands["move"], without=("--fmad=false",))
        self.assertTrue(lint_arithmetic.ptx_complaints(loose))

    def test_oldest(self):
        try:
            entry = lint_arithmetic.kernel_commands(ROOT, BUILD)["move"]
        except lint_sources.Skip as reason:
            self.skipTest(str(reason))
        with tempfile.TemporaryDirectory() as folder:
            for body, compiles in (("__syncwarp(); x[0] = 1u", True), ("x[0] = __reduce_add_sync(~0u, x[1])", False)):
                text = f'#include "cuda/kernels.cuh"\n__global__ void k(unsigned* x) {{ {body}; }}\n'
                source = tree(folder, k_DOT_cu=text) / "k.cu"
                own = {**entry, "command": entry["command"].replace(entry["file"], str(source))}
                self.assertEqual(compiles, lint_arithmetic.compiles_for(own, 75, capture_output=True), body)
                self.assertEqual(not compiles, lint_arithmetic.warp_functions(ROOT, source))

    def test_flags(self):
        def check(command, file="a.cpp"):
            return len(lint_arithmetic.flag_complaints({"command": command, "file": file}))
        self.assertEqual(0, check("g++ -ffp-contract=off -c a.cpp"))
        self.assertEqual(1, check("g++ -c a.cpp"))
        self.assertEqual(1, check("g++ -ffp-contract=off -ffast-math -c a.cpp"))
        self.assertEqual(1, check("nvcc -Xcompiler=-ffp-contract=off,-Wall -c a.cu", "a.cu"))


if __name__ == "__main__":
    unittest.main()
