# SPDX-License-Identifier: MIT
"""Negative controls of the rule on twins, which lint_controls.py runs."""

import pathlib
import tempfile
import unittest

import lint_twins


def tree(folder, **texts):
    """Files named by their path with __ for / and _DOT_ for a dot."""
    for name, text in texts.items():
        path = pathlib.Path(folder, name.replace("__", "/").replace("_DOT_", "."))
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return pathlib.Path(folder)


class Twins(unittest.TestCase):
    COMP = """#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere. More.
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;
shared uint found;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i >= p.n) return;
  atomicAdd(count[i], 2u);
  position[i] = vec4(1.0f, 2.0f, 3.0f, 4.0f);
}
"""
    KERNEL = """// SPDX-License-Identifier: MIT
// One thread
// per sphere. Other.
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) a(Params p, KernelBuffers buf) {
  __shared__ uint found;
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= p.n) return;
  atomicAdd(&buf.count[i], 2u);
  buf.position[i] = vec4{1.0f, 2.0f, 3.0f, 4.0f};
  grid_dependency_sync();  // CUDA only: a reason
}

Entry a_kernel(uint, Variant) { return reinterpret_cast<Entry>(&a); }

}  // namespace spherepair
"""

    def found(self, old="", new="", comp=COMP, kernel=KERNEL, name="a"):
        """How many complaints there are once `old` is `new` in the kernel."""
        self.assertIn(old, kernel)
        texts = {"shaders__a_DOT_comp": comp, f"cuda__{name}_DOT_cu": kernel.replace(old, new) if old else kernel}
        with tempfile.TemporaryDirectory() as folder:
            return len(lint_twins.twins(tree(folder, **texts), None)[0])

    def test_alike(self):
        self.assertEqual(0, self.found())
        self.assertEqual(3, self.found(name="b"))
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue(lint_twins.twins(pathlib.Path(folder), None)[0])

    def test_changes(self):
        for old, new in (("One thread", "Two threads"), ("2u", "3u"), ("i >= p.n", "i > p.n"), ("  if (i >= p.n) return;\n", ""),
                         ("uint found", "int found"), ("  __shared__ uint found;\n", ""), ("buf.count", "buf.id"),
                         ("atomicAdd", "atomicMax"), ("threadIdx.x", "blockIdx.x"), ("  if", "#pragma unroll 1\n  if")):
            self.assertEqual(1, self.found(old, new), old)

    def test_reasons(self):
        self.assertEqual(0, self.found("  if", "#pragma unroll 1  // CUDA only: a reason\n  if"))
        self.assertEqual(0, self.found("  if", "  // CUDA only: a reason\n  a = f(1u,\n        2u);\n  if"))
        self.assertEqual(1, self.found("  // CUDA only: a reason", ""))
        self.assertTrue(self.found("CUDA only: a reason", "CUDA only"))
        self.assertTrue(self.found("CUDA only: a reason", "GLSL only: a reason"))
        block = "  // CUDA only from here: a reason\n  a = b;\n  b = c;\n"
        self.assertEqual(0, self.found("  if", f"{block}  // until here\n  if"))
        self.assertTrue(self.found("  if", f"{block}  if"))
        self.assertEqual(1, self.found("  if", "  // until here\n  if"))
        self.assertEqual(1, self.found("  if (i >= p.n) return;", "  if (i >= p.n) return;  // CUDA only: a reason"))
