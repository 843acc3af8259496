// SPDX-License-Identifier: MIT
// One thread per cluster, or per one that was put off: it is listed to be drawn, or put off, unless it is out of view
// or hidden by what is drawn already. The parts of those that would be drawn are tested too, one thread a part.
#include "listing.cuh"

namespace spherepair {

// The list for what is in such a box, by texels of level 1 or of the level that suits it, or why it is in none.
__device__ inline uint list_for(const World& w, const View& v, vec4 low, vec4 high, bool coarsely) {
  Solid solid = solid_of(low, high, v);
  if (outside(solid, v)) return OUT_OF_VIEW;
  if (v.occlusion == 0u || reaches_eye_plane(solid)) return list_of(v.phase);
  Box box = box_of_solid(solid, v);
  if (box.width == 0u || box.height == 0u) return HIDDEN;
  uint nearest = least_depth(solid, box, v);
  uvec2 texel = texel_of_box(w, v, box, nearest, coarsely ? 1u : level_for(box));
  if (texel.x < nearest) return HIDDEN;
  if (v.phase != PHASE_NEAR || texel.y >= nearest) return list_of(v.phase);
  return texel.y < least_depth(brought_nearer(solid, low, high), box, v) ? LIST_PUT_OFF : LIST_DRAWN;
}

// All threads of the group call it; `enters`: its cluster c does.
__device__ inline void enter(const World& w, const View& v, uint list, bool enters, uint c) {
  uint place = place_in_list(w, DRAWN_CLUSTERS + list, enters);
  if (enters) w.cluster_list[list * v.clusters + place] = c;
}

__device__ inline void count_clusters(const World& w, const View& v, uint word) {
  if (v.counting != 0u) atomicAdd(&w.drawn[word], 1u);
}

__global__ void __launch_bounds__(SERVICE_BLOCK) draw_cull(Params p, World w, View v) {
  __shared__ uint in_parts[SERVICE_BLOCK];    // the clusters whose parts are tested ...
  __shared__ uint parts_list[SERVICE_BLOCK];  // ... and the lists for them
  __shared__ uint in_parts_count;
  uint lane = threadIdx.x;
  bool again = v.phase == PHASE_FAR;
  uint own = list_of(v.phase);
  uint total = again ? w.drawn[DRAWN_CLUSTERS + LIST_PUT_OFF] : v.clusters;
  for (uint first = group_index(p) * SERVICE_BLOCK; first < total; first += group_count() * SERVICE_BLOCK) {
    uint k = first + lane;
    uint c = 0u;
    uint list = OUT_OF_VIEW;
    if (k < total) c = again ? w.cluster_list[LIST_PUT_OFF * v.clusters + k] : place_in_turn(k, v.clusters, v);
    bool exists = k < total && w.cluster[2u * c].x <= w.cluster[2u * c + 1u].x;
    if (exists) list = list_for(w, v, w.cluster[2u * c], w.cluster[2u * c + 1u], true);
    if (lane == 0u) in_parts_count = 0u;
    __syncthreads();
    bool asks = v.occlusion != 0u && list == own;
    uint place = asks ? atomicAdd(&in_parts_count, 1u) : 0u;
    if (asks) in_parts[place] = c;
    if (asks) parts_list[place] = OUT_OF_VIEW;
    __syncthreads();
    for (uint q = lane; q < in_parts_count * CLUSTER_PARTS; q += SERVICE_BLOCK) {
      uint of = in_parts[q / CLUSTER_PARTS];
      Corners part = part_of(w.cluster[2u * of], w.cluster[2u * of + 1u], q % CLUSTER_PARTS);
      atomicMin(&parts_list[q / CLUSTER_PARTS], list_for(w, v, part.low, part.high, false));
    }
    __syncthreads();
    if (asks) list = parts_list[place];
    if (k < total && list == OUT_OF_VIEW) count_clusters(w, v, DRAWN_CLUSTERS_OUTSIDE);
    if (k < total && list == HIDDEN) count_clusters(w, v, DRAWN_CLUSTERS_HIDDEN);
    enter(w, v, own, list == own, c);
    if (v.phase == PHASE_NEAR) enter(w, v, LIST_PUT_OFF, list == LIST_PUT_OFF, c);
  }
}

Entry draw_cull_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_cull); }

}  // namespace spherepair
