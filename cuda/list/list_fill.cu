// SPDX-License-Identifier: MIT
// One group per point or query with many neighbours, in turns until none is left: writes its row of the list. The group
// sorts the keys of the pairs in shared memory. It sorts a row that does not fit there in several ranges of keys.
#include "cuda/list/list_columns.cuh"
#include "cuda/list/list_group.cuh"

namespace spherepair {

__shared__ uint64_t keys[LIST_ROOM];
__shared__ uint found;

// The pairs whose keys are from low to below high; those that there is room for are kept.
__device__ inline uint keys_between(const KernelBuffers& buf, ListLook look, uint64_t low, uint64_t high) {
  float error = buf.list_system[look.system].error;
  uint rows = rows_of(buf, look);
  if (threadIdx.x == 0u) found = 0u;
  __syncthreads();
  for (uint first = 0u; first < rows; first += LIST_BLOCK) {
    uint points = take_rows(buf, look, first, rows);
    uint row = 0u;
    for (uint k = threadIdx.x; k < points; k += LIST_BLOCK) {
      row = row_from(row, k);
      uint at = row_begin[row] + k;
      ivec4 image = row_image[row];
      if (!is_listed(buf, look, error, at, row_shift[row], image)) continue;
      uint64_t key = list_key(buf.id[at], image.x, image.y, image.z);
      if (key < low || key >= high) continue;
      uint n = atomicAdd(&found, 1u);
      if (n < LIST_ROOM) keys[n] = key;
    }
    __syncthreads();
  }
  return found;
}

// Bitonic: of a power of two of keys.
__device__ inline void sort_keys(uint room) {
  for (uint size = 2u; size <= room; size *= 2u) {
    for (uint stride = size / 2u; stride != 0u; stride /= 2u) {
      for (uint k = threadIdx.x; k < room / 2u; k += LIST_BLOCK) {
        uint low = 2u * k - (k & (stride - 1u));
        uint64_t a = keys[low];
        uint64_t b = keys[low + stride];
        if ((a > b) == ((low & size) == 0u)) {
          keys[low] = b;
          keys[low + stride] = a;
        }
      }
      __syncthreads();
    }
  }
}

__device__ inline void write_keys(const KernelBuffers& buf, uint i, uint64_t begin, uint count) {
  uint thread = threadIdx.x;
  if (count <= LIST_RANKED) {
    for (uint k = thread; k < count; k += LIST_BLOCK) {
      uint64_t key = keys[k];
      uint rank = 0u;
      for (uint n = 0u; n < count; ++n) rank += uint(keys[n] < key);
      write_pair(buf, i, begin + uint64_t(rank), key);
    }
    return;
  }
  uint room = room_for(count);
  for (uint k = count + thread; k < room; k += LIST_BLOCK) keys[k] = ~uint64_t(0u);
  __syncthreads();
  sort_keys(room);
  for (uint k = thread; k < count; k += LIST_BLOCK) write_pair(buf, i, begin + uint64_t(k), keys[k]);
}

__device__ inline void write_row(const KernelBuffers& buf, ListLook look, uint length) {
  uint64_t begin = uint64_t(buf.list_begin[look.i]);
  uint64_t end = begin + uint64_t(length);
  uint64_t low = uint64_t(0u);
  uint64_t beyond = uint64_t(buf.list_state[0].points) << 33;
  uint64_t step = beyond;
  while (begin < end && low < beyond) {
    uint count = keys_between(buf, look, low, low + step);
    __syncthreads();
    if (count > LIST_ROOM) {
      step = step >> 1;
    } else {
      write_keys(buf, look.i, begin, count);
      begin += uint64_t(count);
      low += step;
      if (count < LIST_ROOM / 2u) step = step << 1;
    }
    __syncthreads();
  }
}

__global__ void __launch_bounds__(LIST_BLOCK, 24) list_fill(Params p, KernelBuffers buf) {
  bool dense = buf.list_state[0].dense != 0u;
  if (!is_right(buf) || (!dense && buf.list_state[0].longest == 0u)) return;
  for (uint k = group_index(p); k < buf.list_state[0].looking; k += group_count()) {
    ListLook look = buf.list_look[k];
    uint length = length_to_write(buf, look.i);
    if (length > (dense ? 0u : LIST_FEW)) write_row(buf, look, length);
  }
}

Entry list_fill_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_fill); }

}  // namespace spherepair
