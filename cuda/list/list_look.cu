// SPDX-License-Identifier: MIT
// One thread per binned point, then per query: writes the point, wrapped and scaled, and what it looks through.
#include "cuda/list/list_place.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_look(Params p, KernelBuffers buf) {
  uint k = group_index(p) * BLOCK + threadIdx.x;
  uint points = buf.list_state[0].points;
  if (k >= points + buf.list_state[0].queries || !is_right(buf)) return;
  uint element = k < points ? buf.id[k] : k;
  uint i = element - (k < points ? 0u : points);
  vec4 place = place_of(buf, element);
  ListLook look = look_of(buf, i, element);
  buf.sorted[k] = place;
  if (k >= points) {
    buf.list_look[i] = look;
  } else if (!has_flag(buf, LIST_ASKS)) {
    buf.list_look[k] = look;
  }
}

Entry list_look_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_look); }

}  // namespace spherepair
