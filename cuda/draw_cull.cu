// SPDX-License-Identifier: MIT
// One thread per cluster: it is listed to be drawn, unless it is out of view or hidden by what is drawn already.
#include "listing.cuh"

namespace spherepair {

__device__ inline bool is_hidden(const World& w, const View& v, Solid solid) {
  if (reaches_eye_plane(solid)) return false;
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return true;
  return is_hidden(w, v, box, least_depth(solid, box, v), level_for(box));
}

__device__ inline void count_clusters(const World& w, const View& v, uint word) {
  if (v.counting != 0u) atomicAdd(&w.drawn[word], 1u);
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_cull(Params p, World w, View v) {
  uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  bool exists = k < v.clusters;
  uint c = exists ? place_in_turn(k, v.clusters, v) : 0u;
  vec4 low = w.cluster[2u * c];
  vec4 high = w.cluster[2u * c + 1u];
  Solid solid = solid_of(low, high, v);
  bool out_of_view = low.x > high.x || outside(solid, v);
  bool draws = exists && !out_of_view && !(v.occlusion != 0u && is_hidden(w, v, solid));
  if (exists && !draws) count_clusters(w, v, out_of_view ? DRAWN_CLUSTERS_OUTSIDE : DRAWN_CLUSTERS_HIDDEN);
  uint place = place_in_list(w, DRAWN_CLUSTERS, draws);
  if (draws) w.cluster_list[place] = c;
}

Entry draw_cull_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_cull); }

}  // namespace spherepair
