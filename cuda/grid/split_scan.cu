// SPDX-License-Identifier: MIT
// One group, one thread per bucket: turns counts of spheres into begins by an exclusive prefix sum.
#include "cuda/grid/group_sum.cuh"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = BUCKETS_AT_MOST;

__global__ void __launch_bounds__(BLOCK) split_scan(Params p, KernelBuffers buf) {
  uint lane = threadIdx.x;
  uint own = buf.bucket_cursor[lane];
  uint upto = sum_up_to<BLOCK>(own);
  buf.bucket_cursor[lane] = upto - own;
}

Entry split_scan_kernel(uint, Variant) { return reinterpret_cast<Entry>(&split_scan); }

}  // namespace spherepair
