// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: decides whether the two spheres touch at any time within the
// next step. Near pairs are the colliding pairs of spheres around the paths in the step, in any order. SLOT_GROWN holds
// the velocities with which the paths begin.
#include "common/shared/swept.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_swept(Params p, KernelBuffers buf) {
  Collider<false, LISTED> collider(p, buf);
  collider.start_totals();
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < p.search.near_pairs; k += group_count() * BLOCK) {
    uint i = buf.near[k].x;
    uint j = buf.near[k].y;
    bool touch = touch_within(buf.position[i], buf.grown[i], buf.position[j], buf.grown[j], p.motion,
                              p.search.filter_scale, p.search.filter_offset);
    if (!touch) continue;
    collider.record(i, j);
    collider.add_contact(i, 1u);
    collider.add_contact(j, 1u);
  }
  collider.finish_totals();
}

Entry collide_swept_kernel(uint, Variant variant) {
  return variant.listed ? reinterpret_cast<Entry>(&collide_swept<true>)
                        : reinterpret_cast<Entry>(&collide_swept<false>);
}

}  // namespace spherepair
