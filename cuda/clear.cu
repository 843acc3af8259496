// SPDX-License-Identifier: MIT
// One thread per sphere: the results of the last collision step cleared, for a scene that did not move.
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) clear(Params p, World w) {
  clear_results(p, w, group_index(p) * SERVICE_BLOCK + threadIdx.x);
}

Entry clear_kernel() { return reinterpret_cast<Entry>(&clear); }

}  // namespace spherepair
