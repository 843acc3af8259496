// SPDX-License-Identifier: MIT
// A fixed number of threads shares out the deferred pairs: each is decided exactly, and recorded if it collides.
#include "collide.cuh"
#include "exact.h"

namespace spherepair {

template <bool LISTED>
__global__ void __launch_bounds__(SERVICE_BLOCK) settle(Params p, World w) {
  if (w.summary[SUM_DEFERRED] == 0u) return;
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  Collider<false, LISTED> c(p, w, total);
  c.start_totals();
  uint pairs = min(w.summary[SUM_DEFERRED], p.deferred_capacity);
  uint row = (group_index(p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
  for (uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x; k < pairs; k += SERVICE_BLOCK * gridDim.x) {
    uvec2 pair = w.deferred[k];
    Verdict verdict = decide_exact(w.position[pair.x], w.position[pair.y]);
    atomicAdd(&w.summary[row + SUM_STAGE + verdict.stage], 1u);
    if (verdict.collide) {
      c.record(c.sphere_at(pair.x), c.sphere_at(pair.y));
      c.touch(pair.x, 1u);
      c.touch(pair.y, 1u);
    }
  }
  c.finish_totals();
}

Entry settle_kernel(uint, Variant variant) {
  return variant.listed ? reinterpret_cast<Entry>(&settle<true>) : reinterpret_cast<Entry>(&settle<false>);
}

}  // namespace spherepair
