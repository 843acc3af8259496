// SPDX-License-Identifier: MIT
// A fixed number of threads loops over the deferred pairs: each pair is decided exactly and recorded if it collides.
#include "common/shared/exact.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <bool LISTED>
__global__ void __launch_bounds__(BLOCK) resolve_undecided(Params p, KernelBuffers buf) {
  uint k = group_index(p) * BLOCK + threadIdx.x;
  uvec2 pair = buf.deferred[min(
      k, p.search.deferred_capacity - 1u)];  // loaded before it is known to exist, to overlap the two latencies
  uint pairs = min(buf.summary[SUM_DEFERRED], p.search.deferred_capacity);
  if (group_index(p) * BLOCK >= pairs) return;
  Collider<false, LISTED> collider(p, buf);
  collider.start_totals();
  uint row = (group_index(p) % SUMMARY_SLOTS) * SUMMARY_WORDS;
  for (; k < pairs; k += BLOCK * gridDim.x) {
    vec4 a = buf.position[pair.x];
    vec4 b = buf.position[pair.y];
    Verdict verdict = decide_exact(with_radius(p, a), with_radius(p, b));
    atomicAdd(&buf.summary[row + SUM_STAGE + verdict.stage], 1u);
    if (verdict.collide) {
      collider.record(sphere_index(p, buf, a, pair.x), sphere_index(p, buf, b, pair.y));
      collider.add_contact(pair.x, 1u);
      collider.add_contact(pair.y, 1u);
    }
    pair = buf.deferred[min(k + BLOCK * gridDim.x, p.search.deferred_capacity - 1u)];
  }
  collider.finish_totals();
}

Entry resolve_undecided_kernel(uint, Variant variant) {
  return variant.listed ? reinterpret_cast<Entry>(&resolve_undecided<true>)
                        : reinterpret_cast<Entry>(&resolve_undecided<false>);
}

}  // namespace spherepair
