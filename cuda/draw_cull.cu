// SPDX-License-Identifier: MIT
// One thread per cluster: whether it is drawn in this phase, and in the second whether the next picture draws it first.
#include "cluster.h"
#include "kernels.cuh"

namespace spherepair {

__device__ inline bool hidden(const World& w, const View& v, Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  uint level = level_for(box, v);
  uint shift = 3u + 2u * level;
  uint first = first_texel(level, v);
  uint width = texels_along(v.width, level);
  uint nearest = least_depth(solid, box, v);
  for (uint y = box.y >> shift; y <= (box.y + box.height - 1u) >> shift; ++y)
    for (uint x = box.x >> shift; x <= (box.x + box.width - 1u) >> shift; ++x)
      if (w.pyramid[first + y * width + x] >= nearest) return false;
  return true;
}

__device__ inline void count_clusters(const World& w, const View& v, uint word) {
  if (v.counting != 0u && v.phase == PHASE_REST) atomicAdd(&w.drawn[word], 1u);
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_cull(Params p, World w, View v) {
  uint c = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  if (c >= v.clusters) return;
  vec4 low = w.cluster[2u * c];
  vec4 high = w.cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool first = v.occlusion != 0u && !out_of_view && w.cluster_seen[c] != 0u;
  bool seen = !out_of_view;
  if (v.phase == PHASE_REST && v.occlusion != 0u) {
    seen = seen && !hidden(w, v, solid);
    w.cluster_seen[c] = seen ? 1u : 0u;
  }
  if (out_of_view) count_clusters(w, v, DRAWN_CLUSTERS_OUTSIDE);
  if (!out_of_view && !seen && !first) count_clusters(w, v, DRAWN_CLUSTERS_HIDDEN);
  if (v.phase == PHASE_SEEN ? first : seen && !first) w.cluster_list[atomicAdd(&w.drawn[DRAWN_CLUSTERS], 1u)] = c;
}

Entry draw_cull_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_cull); }

}  // namespace spherepair
