// SPDX-License-Identifier: MIT
// Sorts a pair list into canonical order by Thrust's radix sort, before it leaves the device.
#include "cuda/host/sort_pairs.h"

#include <thrust/device_ptr.h>
#include <thrust/sort.h>
#include <thrust/transform.h>

#include "common/shared/layout.h"

namespace spherepair {
namespace {

// Swaps the halves of a word. A little-endian uvec2 read as one 64-bit word has its first index in the low half; with
// swapped halves the order of the words is the order of the pairs.
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
