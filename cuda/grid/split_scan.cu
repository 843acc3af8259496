// SPDX-License-Identifier: MIT
// One group: the numbers of spheres in the buckets become the places where these begin, a bucket a thread.
#include "cuda/grid/group_sum.cuh"
#include "cuda/kernels.cuh"

namespace spherepair {

__global__ void __launch_bounds__(BUCKETS_AT_MOST) split_scan(Params p, KernelBuffers w) {
  uint lane = threadIdx.x;
  uint own = w.bucket_cursor[lane];
  uint upto = sum_up_to<BUCKETS_AT_MOST>(own);
  w.bucket_cursor[lane] = upto - own;
}

Entry split_scan_kernel(uint, Variant) { return reinterpret_cast<Entry>(&split_scan); }

}  // namespace spherepair
