// SPDX-License-Identifier: MIT
// One thread per point, then per query: writes it, wrapped and scaled, and what it looks through. A point goes to its
// place in its cell.
#include "cuda/list/list_place.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_look(Params p, KernelBuffers buf) {
  uint element = group_index(p) * BLOCK + threadIdx.x;
  uint points = buf.list_state[0].points;
  if (element >= points + buf.list_state[0].queries || !is_right(buf)) return;
  vec4 place = place_of(buf, element);
  if (element >= points) {
    buf.sorted[element] = place;
    buf.list_look[element - points] = look_of(buf, element - points, element);
  } else {
    uvec2 bin = buf.list_bins[element];
    uint at = buf.cell[bin.x] + bin.y;
    buf.id[at] = element;
    buf.sorted[at] = place;
    if (!has_flag(buf, LIST_ASKS)) buf.list_look[at] = look_of(buf, element, element);
  }
}

Entry list_look_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_look); }

}  // namespace spherepair
