// SPDX-License-Identifier: MIT
// Thrust's radix sort puts a pair list into canonical order before it leaves the device.
#include "cuda/host/sort_pairs.h"

#include <thrust/device_ptr.h>
#include <thrust/sort.h>
#include <thrust/transform.h>

#include "common/shared/layout.h"

namespace spherepair {
namespace {

// A little-endian uvec2 read as one 64-bit word holds its first index in the low half: the halves change places, so
// that the order of the words is the order of the pairs.
struct SwapHalves {
  __host__ __device__ uint64_t operator()(uint64_t word) const { return word << 32 | word >> 32; }
};

}  // namespace

void sort_pairs(void* pairs, uint64_t count) {
  const thrust::device_ptr<uint64_t> first(static_cast<uint64_t*>(pairs)), last = first + count;
  thrust::transform(first, last, first, SwapHalves{});
  thrust::sort(first, last);
  thrust::transform(first, last, first, SwapHalves{});
}

}  // namespace spherepair
