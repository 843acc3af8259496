// SPDX-License-Identifier: MIT
// One thread per sphere: it is drawn, unless it is large, which draw_tiles then does.
#include "visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_spheres(Params p, World w, View v) {
  uint place = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (place < p.n) draw_sphere(p, w, v, place);
}

Entry draw_spheres_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_spheres); }

}  // namespace spherepair
