// SPDX-License-Identifier: MIT
// A fixed number of groups of CLUSTER threads shares out the list of clusters to draw; one thread per sphere.
#include "visible.cuh"

namespace spherepair {

__global__ void __launch_bounds__(CLUSTER) draw_clusters(Params p, World w, View v) {
  uint first = v.pass == PASS_ID ? 0u : w.drawn[DRAWN_CLUSTERS_DONE];
  for (uint k = first + group_index(p); k < w.drawn[DRAWN_CLUSTERS]; k += group_count()) {
    uint place = w.cluster_list[k] * CLUSTER + threadIdx.x;
    if (place < p.n) draw_sphere(p, w, v, place);
  }
}

Entry draw_clusters_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_clusters); }

}  // namespace spherepair
