// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: decides whether the two spheres collide in a periodic box. Near
// pairs are those of contacts, in any order.
#include "common/shared/contact/image_pair.h"
#include "cuda/collide/collide.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

template <bool LISTED>
__global__ void __launch_bounds__(BLOCK) collide_images(Params p, KernelBuffers buf) {
  Collider<false, LISTED> collider(p, buf);
  collider.start_totals();
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < p.search.near_pairs; k += group_count() * BLOCK) {
    uint i = buf.near[k].x;
    uint j = buf.near[k].y;
    if (i == j) continue;  // none
    if (!images_collide(buf.position[i], buf.position[j], p.contact, p.search.filter_scale, p.search.filter_offset))
      continue;
    collider.record(i, j);
    collider.add_contact(i, 1u);
    collider.add_contact(j, 1u);
  }
  collider.finish_totals();
}

Entry collide_images_kernel(uint, Variant variant) {
  return variant.listed ? reinterpret_cast<Entry>(&collide_images<true>)
                        : reinterpret_cast<Entry>(&collide_images<false>);
}

}  // namespace spherepair
