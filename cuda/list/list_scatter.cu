// SPDX-License-Identifier: MIT
// One thread per element: writes a point, wrapped and scaled, to the next index of its cell, and what a point or a
// query looks through. The slot after a cell's own is the write cursor, and so, in the end, the begin of the next cell.
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

// The first and the last cell of the reach along an axis.
__device__ inline ivec2 cells_within(const KernelBuffers& buf, uint element, uint s, uint k) {
  EXACT double at = wrapped_coordinate(buf, element, k) - buf.list_system[s].low[k];
  EXACT double span =
      (buf.list_system[s].reach + buf.list_given[element].w) * buf.list_system[s].span[k] + buf.list_system[s].slack[k];
  EXACT double low = (at - span) * buf.list_system[s].cells_per_unit[k];
  EXACT double high = (at + span) * buf.list_system[s].cells_per_unit[k];
  if ((buf.list_system[s].periodic >> k & 1u) == 0u) {
    double cells = double(buf.list_system[s].cells[k]);
    EXACT double last = cells - double(1.0f);
    if (high < double(0.0f) || low >= cells) return ivec2{0, -1};
    low = low < double(0.0f) ? double(0.0f) : low;
    high = high > last ? last : high;
  }
  return ivec2{floor_of(low), floor_of(high)};
}

__device__ inline void write_look(const KernelBuffers& buf, uint k, uint i, uint element, vec4 place) {
  uint s = uint(buf.list_place[element].w);
  ivec2 x = cells_within(buf, element, s, 0u);
  ivec2 y = cells_within(buf, element, s, 1u);
  ivec2 z = cells_within(buf, element, s, 2u);
  EXACT double reach =
      (buf.list_state[0].cutoff + buf.list_state[0].skin + buf.list_given[element].w) * buf.list_system[s].scale;
  place.w = float(reach);
  buf.list_look[k] = ListLook{place, x.x, y.x, z.x, x.y, y.y, z.y, i, s};
}

__global__ void __launch_bounds__(BLOCK) list_scatter(Params p, KernelBuffers buf) {
  uint i = group_index(p) * BLOCK + threadIdx.x;
  if (i >= buf.list_state[0].points + buf.list_state[0].queries) return;
  if ((buf.list_state[0].wrong | buf.list_state[0].far | buf.list_state[0].wide) != 0u) return;
  EXACT double radius = buf.list_given[i].w * buf.list_system[buf.list_place[i].w].scale;
  vec4 place = vec4{place_along(buf, i, 0u), place_along(buf, i, 1u), place_along(buf, i, 2u), float(radius)};
  if (i >= buf.list_state[0].points) {
    write_look(buf, i - buf.list_state[0].points, i - buf.list_state[0].points, i, place);
    return;
  }
  uint at = atomicAdd(&buf.cell[cell_of(buf, i) + 1u], 1u);
  buf.sorted[at] = place;
  buf.id[at] = i;
  if (!has_flag(buf, LIST_ASKS)) write_look(buf, at, i, i, place);
}

Entry list_scatter_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_scatter); }

}  // namespace spherepair
