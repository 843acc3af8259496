// SPDX-License-Identifier: MIT
// A fixed number of threads shares out the deferred pairs: each is decided exactly, and recorded if it collides.
#include "common/shared/exact.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

template <bool LISTED>
__global__ void __launch_bounds__(SERVICE_BLOCK) resolve_undecided(Params p, KernelBuffers w) {
  __shared__ uint total[TOTAL_ROWS * TOTAL_STRIDE];
  uint k = group_index(p) * SERVICE_BLOCK + threadIdx.x;
  uvec2 pair = w.deferred[min(k, p.deferred_capacity - 1u)];  // on its way before it is known to be one
  uint pairs = min(w.summary[SUM_DEFERRED], p.deferred_capacity);
  if (group_index(p) * SERVICE_BLOCK >= pairs) return;
  Collider<false, LISTED> c(p, w, total);
  c.start_totals();
  uint row = (group_index(p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
  for (; k < pairs; k += SERVICE_BLOCK * gridDim.x) {
    vec4 a = w.position[pair.x];
    vec4 b = w.position[pair.y];
    Verdict verdict = decide_exact(with_radius(p, a), with_radius(p, b));
    atomicAdd(&w.summary[row + SUM_STAGE + verdict.stage], 1u);
    if (verdict.collide) {
      if (!c.totals_later()) c.record(sphere_index(p, w, a, pair.x), sphere_index(p, w, b, pair.y));
      c.add_contact(pair.x, 1u);
      c.add_contact(pair.y, 1u);
    }
    pair = w.deferred[min(k + SERVICE_BLOCK * gridDim.x, p.deferred_capacity - 1u)];
  }
  c.finish_totals();
}

Entry resolve_undecided_kernel(uint, Variant variant) {
  return variant.listed ? reinterpret_cast<Entry>(&resolve_undecided<true>)
                        : reinterpret_cast<Entry>(&resolve_undecided<false>);
}

}  // namespace spherepair
