// SPDX-License-Identifier: MIT
// Wraps a point into its system's box, and adds it to the extremes of the system. Those of one system are added up by
// the threads, then in shared memory.
#pragma once

#include "cuda/list/list.cuh"

namespace spherepair {

__shared__ uint extreme[LIST_EXTREMES];
__shared__ uint group_system;

struct Extremes {
  uint of[LIST_EXTREMES];
};

__device__ inline Extremes no_extremes() {
  Extremes none;
  for (uint which = 0u; which < LIST_EXTREMES; ++which) none.of[which] = 0u;
  return none;
}

__device__ inline Extremes noted(const KernelBuffers& buf, Extremes own, uint s, uint which, uint value) {
  if (s == group_system) {
    own.of[which] = max(own.of[which], value);
  } else if (value != 0u) {
    atomicMax(&buf.list_system[s].extreme[which], value);
  }
  return own;
}

// Returns by how many boxes a point is wrapped along an axis; 0 if the axis is not periodic.
__device__ inline int boxes_along(const KernelBuffers& buf, uint i, uint s, uint k) {
  if ((buf.list_system[s].periodic >> k & 1u) == 0u) return 0;
  double at = list_coordinate(buf.list_system[s].dual, k, buf.list_given[i]);
  if (magnitude(at) < double(1073741824.0f)) return floor_of(at);
  atomicMax(&buf.list_state[0].far, ~i);
  return 0;
}

__device__ inline Extremes measured(const KernelBuffers& buf, Extremes own, uint i, uint s) {
  dvec4 x = buf.list_given[i];
  bool point = i < buf.list_state[0].points;
  buf.list_place[i] = ivec4{0, 0, 0, int(s)};
  if (!(is_listed_number(x.x) && is_listed_number(x.y) && is_listed_number(x.z) && is_listed_number(x.w)) ||
      x.w < double(0.0f)) {
    atomicMax(&buf.list_state[0].wrong, ~i);
    return own;
  }
  ivec4 boxes = ivec4{boxes_along(buf, i, s, 0u), boxes_along(buf, i, s, 1u), boxes_along(buf, i, s, 2u), int(s)};
  buf.list_place[i] = boxes;
  own = noted(buf, own, s, LIST_CELLS, uint(max(boxes.x, -boxes.x)));
  own = noted(buf, own, s, LIST_CELLS + 1u, uint(max(boxes.y, -boxes.y)));
  own = noted(buf, own, s, LIST_CELLS + 2u, uint(max(boxes.z, -boxes.z)));
  for (uint k = 0u; k < 3u; ++k) {
    if (!point || (buf.list_system[s].periodic >> k & 1u) != 0u) continue;
    uint at = ordered_high(list_coordinate(buf.list_system[s].dual, k, x));
    own = noted(buf, own, s, LIST_LOW + k, ~at);
    own = noted(buf, own, s, LIST_HIGH + k, at);
  }
  uint size = max(ordered_high(magnitude(x.x)), max(ordered_high(magnitude(x.y)), ordered_high(magnitude(x.z))));
  own = noted(buf, own, s, LIST_LARGEST, size);
  if (point) own = noted(buf, own, s, LIST_RADIUS, ordered_high(x.w));
  if (!point || !has_flag(buf, LIST_ASKS)) own = noted(buf, own, s, LIST_LOOKING_RADIUS, ordered_high(x.w));
  return own;
}

__device__ inline void add_up(Extremes own) {
  for (uint which = 0u; which < LIST_EXTREMES; ++which)
    if (own.of[which] != 0u) atomicMax(&extreme[which], own.of[which]);
}

}  // namespace spherepair
