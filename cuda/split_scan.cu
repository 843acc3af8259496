// SPDX-License-Identifier: MIT
// One group: the numbers of spheres in the buckets become the places where these begin, a bucket a thread.
#include "kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(SPLIT_BLOCK) split_scan(Params p, World w) {
  __shared__ uint sums[SPLIT_BLOCK];
  uint lane = threadIdx.x;
  uint own = w.next_place[lane];
  uint upto = own;
  for (uint step = 1u; step < SPLIT_BLOCK; step *= 2u) {
    sums[lane] = upto;
    __syncthreads();
    if (lane >= step) upto += sums[lane - step];
    __syncthreads();
  }
  w.next_place[lane] = upto - own;
}

Entry split_scan_kernel() { return reinterpret_cast<Entry>(&split_scan); }

}  // namespace spherepair
