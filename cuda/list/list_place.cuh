// SPDX-License-Identifier: MIT
// Where a point lies, wrapped and scaled, and what it looks through.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

__device__ inline vec4 place_of(const KernelBuffers& buf, uint element) {
  EXACT double radius = buf.list_given[element].w * buf.list_system[buf.list_place[element].w].scale;
  return vec4{place_along(buf, element, 0u), place_along(buf, element, 1u), place_along(buf, element, 2u),
              float(radius)};
}

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

__device__ inline ListLook look_of(const KernelBuffers& buf, uint i, uint element) {
  uint s = uint(buf.list_place[element].w);
  ListLook look;
  for (uint k = 0u; k < 3u; ++k) {
    ivec2 cells = cells_within(buf, element, s, k);
    look.low[k] = cells.x;
    look.high[k] = cells.y + 1;
  }
  look.i = i;
  look.system = s;
  return look;
}

}  // namespace spherepair
