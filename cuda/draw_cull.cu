// SPDX-License-Identifier: MIT
// One thread per cluster: whether it is drawn in the second phase, and whether the next picture draws it in the first.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline bool hidden(const World& w, const View& v, Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  uint level = texels_of(box, 0u) > uint(TEXELS_AT_MOST) ? 1u : 0u;
  if (texels_of(box, level) > uint(TEXELS_TO_SEARCH)) return false;
  uint shift = texel_shift(level);
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  uint nearest = least_depth(solid, box, v);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (w.pyramid[first + y * width + x] >= nearest) return false;
  return true;
}

__device__ inline void count_clusters(const World& w, const View& v, uint word) {
  if (v.counting != 0u) atomicAdd(&w.drawn[word], 1u);
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_cull(Params p, World w, View v) {
  __shared__ uint entries[2];  // of the group: clusters to draw, and to draw first in the next picture
  __shared__ uint first_entry[2];
  uint lane = threadIdx.x;
  uint k = group_index(p) * SERVICE_BLOCK + lane;
  bool exists = k < v.clusters;
  uint c = exists ? place_in_turn(k, v.clusters, v) : 0u;
  vec4 low = w.cluster[2u * c];
  vec4 high = w.cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool first = v.occlusion != 0u && w.cluster_seen[c] != 0u;
  bool seen = exists && !out_of_view && !(v.occlusion != 0u && hidden(w, v, solid));
  bool keeps = seen && v.occlusion != 0u;
  if (exists && v.occlusion != 0u) w.cluster_seen[c] = seen ? 1u : 0u;
  if (exists && out_of_view) count_clusters(w, v, DRAWN_CLUSTERS_OUTSIDE);
  if (exists && !out_of_view && !seen && !first) count_clusters(w, v, DRAWN_CLUSTERS_HIDDEN);

  bool draws = seen && !first;
  if (lane < 2u) entries[lane] = 0u;
  __syncthreads();
  uint drawn_place = draws ? atomicAdd(&entries[0], 1u) : 0u;
  uint kept_place = keeps ? atomicAdd(&entries[1], 1u) : 0u;
  __syncthreads();
  uint next = 1u - v.turn;
  if (lane < 2u && entries[lane] > 0u)
    first_entry[lane] = atomicAdd(&w.drawn[lane == 0u ? DRAWN_CLUSTERS : DRAWN_SEEN + next], entries[lane]);
  __syncthreads();
  if (draws) w.cluster_list[2u * v.clusters + first_entry[0] + drawn_place] = c;
  if (keeps) w.cluster_list[next * v.clusters + first_entry[1] + kept_place] = c;
}

Entry draw_cull_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_cull); }

}  // namespace spherepair
