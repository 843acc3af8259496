// SPDX-License-Identifier: MIT
// A fixed number of threads loops over the spheres: counts those with a contact.
#include "cuda/collide/collide.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) tally(Params p, KernelBuffers buf) {
  Collider<false, false> collider(p, buf);
  uint colliding = 0u;
  collider.start_totals();
  for (uint i = group_index(p) * BLOCK + threadIdx.x; i < p.n; i += BLOCK * gridDim.x)
    if (buf.count[i] != 0u) colliding += 1u;
  if (colliding != 0u) collider.add_to_total(SUM_COLLIDING, uint64_t(colliding));
  collider.finish_totals();
}

Entry tally_kernel(uint, Variant) { return reinterpret_cast<Entry>(&tally); }

}  // namespace spherepair
