// SPDX-License-Identifier: MIT
// A fixed number of groups shares out a list of clusters, or all; one thread per sphere.
#define VISIBLE_LOAD __ldca  // what was seen long ago hides as well
#include "cuda/draw/batch.cuh"

namespace spherepair {

template <bool BUNDLES>
__global__ void __launch_bounds__(CLUSTERS_BLOCK) draw_clusters(Params p, KernelBuffers w, View v) {
  constexpr uint at_once = CLUSTERS_BLOCK / CLUSTER;
  uint list = list_of(v.phase);
  bool all = !BUNDLES && v.phase == PHASE_ALL;  // bundles are of more
  uint count = all ? v.clusters : w.drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index(p) * at_once; first < count; first += group_count() * at_once) {
    uint k = first + threadIdx.x / CLUSTER;
    uint cluster = place_in_turn(k, count, v);
    if (!all && k < count) cluster = w.cluster_list[list * v.clusters + k];
    uint sorted_index = cluster * CLUSTER + threadIdx.x % CLUSTER;
    draw_batch<CLUSTERS_BLOCK>(p, w, v, sorted_index, k < count && sorted_index < p.n);
  }
}

Entry draw_clusters_kernel(uint, Variant variant) {
  return variant.bundles ? reinterpret_cast<Entry>(&draw_clusters<true>)
                         : reinterpret_cast<Entry>(&draw_clusters<false>);
}

}  // namespace spherepair
