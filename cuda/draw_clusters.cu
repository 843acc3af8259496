// SPDX-License-Identifier: MIT
// A fixed number of groups of CLUSTER threads shares out the phase's list of clusters; one thread per sphere.
#include "visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(CLUSTER) draw_clusters(Params p, World w, View v) {
  bool rest = v.phase == PHASE_REST;
  uint first = (rest ? 2u : v.turn) * v.clusters;
  uint count = w.drawn[rest ? DRAWN_CLUSTERS : DRAWN_SEEN + v.turn];
  for (uint k = group_index(p); k < count; k += group_count()) {
    uint place = w.cluster_list[first + k] * CLUSTER + threadIdx.x;
    if (place < p.n) draw_sphere(p, w, v, place, 0u);
  }
}

Entry draw_clusters_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clusters); }

}  // namespace spherepair
