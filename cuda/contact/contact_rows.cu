// SPDX-License-Identifier: MIT
// One thread per near pair, looping until none is left: adds each of the two spheres to the other's row, in any order.
// If rows are too short, the longest length is recorded, and all rows are filled again.
#include "common/shared/contact/skin.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__device__ inline void join_row(const Params& p, const KernelBuffers& buf, uint i, uint j) {
  uint k = atomicAdd(&buf.row_length[i], 1u);
  if (k < p.contact.row_capacity) {
    buf.row[k * p.n + i] = j;
  } else {
    atomicMax(&buf.fault[LONGEST_ROW], k + 1u);
  }
}

__global__ void __launch_bounds__(BLOCK) contact_rows(Params p, KernelBuffers buf) {
  uint pairs = p.search.near_pairs;
  for (uint k = group_index(p) * BLOCK + threadIdx.x; k < pairs; k += group_count() * BLOCK) {
    join_row(p, buf, buf.near[k].x, buf.near[k].y);
    join_row(p, buf, buf.near[k].y, buf.near[k].x);
  }
}

Entry contact_rows_kernel(uint, Variant) { return reinterpret_cast<Entry>(&contact_rows); }

}  // namespace spherepair
