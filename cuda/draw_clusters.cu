// SPDX-License-Identifier: MIT
// A fixed number of groups of BATCH threads shares out a list of clusters; one thread per sphere.
#define VISIBLE_LOAD __ldca  // what was seen long ago hides as well
#include "batch.cuh"

namespace spherepair {

__global__ void __launch_bounds__(BATCH) draw_clusters(Params p, World w, View v) {
  constexpr uint at_once = BATCH / CLUSTER;
  uint list = list_of(v.phase);
  uint count = w.drawn[DRAWN_CLUSTERS + list];
  for (uint first = group_index(p) * at_once; first < count; first += group_count() * at_once) {
    uint k = first + threadIdx.x / CLUSTER;
    uint place = k < count ? w.cluster_list[list * v.clusters + k] * CLUSTER + threadIdx.x % CLUSTER : p.n;
    draw_batch(p, w, v, place, place < p.n);
  }
}

Entry draw_clusters_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clusters); }

}  // namespace spherepair
