// SPDX-License-Identifier: MIT
// A fixed number of threads shares out the spheres: how many have a contact.
#include "cuda/collide/collide.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SERVICE_BLOCK) tally(Params p, KernelBuffers w) {
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<false, false> c(p, w, total);
  uint colliding = 0u;
  c.start_totals();
  for (uint i = group_index(p) * SERVICE_BLOCK + threadIdx.x; i < p.n; i += SERVICE_BLOCK * gridDim.x)
    if (w.count[i] != 0u) colliding += 1u;
  if (colliding != 0u) c.add_to_total(SUM_COLLIDING, uint64_t(colliding));
  c.finish_totals();
}

Entry tally_kernel(uint, Variant) { return reinterpret_cast<Entry>(&tally); }

}  // namespace spherepair
