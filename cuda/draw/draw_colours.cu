// SPDX-License-Identifier: MIT
// One thread per sphere: writes the entry of the palette that its radius or speed chooses.
#include "common/shared/draw.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) draw_colours(Params p, KernelBuffers buf, View v) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i < p.n) buf.colour[i] = palette_entry(buf.position[i], buf.velocity[i], v);
}

Entry draw_colours_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_colours); }

}  // namespace spherepair
