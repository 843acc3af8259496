// SPDX-License-Identifier: MIT
// One thread per sphere; a fixed number of groups loops over a list of clusters, or all of them, and draws the spheres.
#define VISIBLE_LOAD __ldca  // a stale depth only costs time
#include "cuda/draw/batch.cuh"

namespace spherepair {

constexpr uint BLOCK = CLUSTERS_BLOCK;

template <bool BUNDLES>
__global__ void __launch_bounds__(BLOCK) draw_clusters(Params p, KernelBuffers buf, View v) {
  constexpr uint at_once = BLOCK / CLUSTER;
  uint list = list_of(v.phase);
  bool all = !BUNDLES && v.phase == PHASE_ALL;  // bundles are for more clusters
  uint count = all ? v.clusters : buf.drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index(p) * at_once; first < count; first += group_count() * at_once) {
    uint k = first + threadIdx.x / CLUSTER;
    uint cluster = front_to_back(k, count, v);
    if (!all && k < count) cluster = buf.cluster_list[list * v.clusters + k];
    uint i = cluster * CLUSTER + threadIdx.x % CLUSTER;
    draw_batch<BLOCK>(p, buf, v, i, k < count && i < p.n);
  }
}

Entry draw_clusters_kernel(uint, Variant variant) {
  return variant.bundles ? reinterpret_cast<Entry>(&draw_clusters<true>)
                         : reinterpret_cast<Entry>(&draw_clusters<false>);
}

}  // namespace spherepair
