// SPDX-License-Identifier: MIT
// One group per 2^order_bits rows, LIST_ORDER_BLOCK at most: sorts the keys of each row, and writes its columns. A
// row has 2^bits threads, as many as the longest row of the group needs. Each sorts LIST_KEYS_EACH keys in registers. A
// row that is too long for 32 threads is sorted in several ranges of keys.
#include "cuda/list/list_length.cuh"

namespace spherepair {

__shared__ uint keys[LIST_SLOT * LIST_ORDER_BLOCK];
__shared__ uint lengths[LIST_ORDER_BLOCK];  // of the rows in `keys`
__shared__ uint longest, found;

// CUDA only from here: threads of a warp exchange values by themselves
__device__ inline uint exchanged(uint value, uint mask) { return __shfl_xor_sync(~0u, value, mask); }
// until here

// What the keys of a row have in common.
struct RowKeys {
  ivec4 place;             // of the point or query
  uint first_point, bits;  // of the system; of an image's number
  Images images;
  bool wrapped;  // whether any point or query of the system lies outside its box
};
__device__ inline RowKeys keys_of_row(const KernelBuffers& buf, uint i) {
  RowKeys row;
  row.place = buf.list_place[element_of(buf, i)];
  uint s = uint(row.place.w);
  row.first_point = buf.list_system[s].first_point;
  row.bits = buf.list_system[s].key_bits;
  row.images = images_of(buf, s);
  row.wrapped = (buf.list_system[s].extreme[LIST_CELLS] | buf.list_system[s].extreme[LIST_CELLS + 1] |
                 buf.list_system[s].extreme[LIST_CELLS + 2]) != 0u;
  return row;
}

struct OwnKeys {
  uint of[LIST_KEYS_EACH];
};

// A step of the sort among the keys of a thread, whose first key is given: compares those that are a stride apart. Keys
// ascend where bit `level` of their index is 0.
__device__ inline OwnKeys compared(OwnKeys own, uint first, uint level, uint stride) {
#pragma unroll  // CUDA only: so that keys stay in registers
  for (uint r = 0u; r < LIST_KEYS_EACH; ++r) {
    if ((r & stride) == 0u) {
      bool ascends = ((first + r) >> level & 1u) == 0u;
      uint low = min(own.of[r], own.of[r + stride]);
      uint high = max(own.of[r], own.of[r + stride]);
      own.of[r] = ascends ? low : high;
      own.of[r + stride] = ascends ? high : low;
    }
  }
  return own;
}

// Sorts the keys of 2^bits threads, bitonic. Each then has LIST_KEYS_EACH consecutive keys.
__device__ inline OwnKeys sorted_keys(OwnKeys own, uint bits) {
  uint first = (threadIdx.x & ((1u << bits) - 1u)) * LIST_KEYS_EACH;
#pragma unroll  // CUDA only: as above
  for (uint level = 1u; level <= LIST_EACH_BITS; ++level)
#pragma unroll  // CUDA only: as above
    for (uint down = 1u; down <= level; ++down) own = compared(own, first, level, 1u << (level - down));
  for (uint level = LIST_EACH_BITS + 1u; level <= LIST_EACH_BITS + bits; ++level) {
    for (uint stride = 1u << (level - 1u); stride >= LIST_KEYS_EACH; stride /= 2u) {
      bool least = ((first >> level & 1u) == 0u) == ((first & stride) == 0u);
#pragma unroll  // CUDA only: as above
      for (uint r = 0u; r < LIST_KEYS_EACH; ++r) {
        uint other = exchanged(own.of[r], stride / LIST_KEYS_EACH);
        own.of[r] = least ? min(own.of[r], other) : max(own.of[r], other);
      }
    }
#pragma unroll  // CUDA only: as above
    for (uint down = 1u; down <= LIST_EACH_BITS; ++down) own = compared(own, first, level, LIST_KEYS_EACH >> down);
  }
  return own;
}

// Sorts rows, a row for 2^bits threads. Key n of a row is then n + n / LIST_KEYS_EACH words behind its first in `keys`.
__device__ inline void sort_rows(OwnKeys own, uint bits) {
  uint thread = threadIdx.x;
  own = sorted_keys(own, bits);
  uint begin = (thread >> bits) * (LIST_SLOT << bits) + (thread & ((1u << bits) - 1u)) * LIST_SLOT;
#pragma unroll  // CUDA only: as above
  for (uint r = 0u; r < LIST_KEYS_EACH; ++r) keys[begin + r] = own.of[r];
  __syncthreads();
}

__device__ inline uint key_at(uint row, uint bits, uint n) {
  return keys[row * (LIST_SLOT << bits) + n + n / LIST_KEYS_EACH];
}

// Writes the shifts of a sorted row, whose first pair is number `begin`. Only systems with wrapped points read the
// places of second points; a thread reads several before it writes, so that their loads overlap.
__device__ inline void write_shifts(const KernelBuffers& buf, uint i, uint row, uint bits, uint64_t begin, uint lanes) {
  RowKeys row_keys = keys_of_row(buf, i);
  uint length = lengths[row];
  for (uint n = threadIdx.x % lanes; n < length; n += LIST_WRITES * lanes) {
    ivec4 image[LIST_WRITES];
    ivec4 other[LIST_WRITES];
#pragma unroll  // CUDA only: as above
    for (uint q = 0u; q < LIST_WRITES; ++q) {
      uint key = key_at(row, bits, min(n + q * lanes, length - 1u));
      image[q] = image_of(row_keys.images, key & ((1u << row_keys.bits) - 1u));
      other[q] = row_keys.place;
      if (row_keys.wrapped) other[q] = buf.list_place[row_keys.first_point + (key >> row_keys.bits)];
    }
#pragma unroll  // CUDA only: as above
    for (uint q = 0u; q < LIST_WRITES; ++q) {
      if (n + q * lanes >= length) continue;
      uint64_t first = uint64_t(3u) * (begin + uint64_t(n + q * lanes));
      buf.list_shift[column_index(first)] = image[q].x + row_keys.place.x - other[q].x;
      buf.list_shift[column_index(first) + 1u] = image[q].y + row_keys.place.y - other[q].y;
      buf.list_shift[column_index(first) + 2u] = image[q].z + row_keys.place.z - other[q].z;
    }
  }
}

// Writes the columns of sorted rows from row i on, behind the pairs of each that are written.
__device__ inline void write_rows(const KernelBuffers& buf, uint i, uint rows, uint bits, uint64_t written) {
  uint flags = buf.list_state[0].flags;
  uint lanes = min(4u << bits, 32u);
  for (uint row = threadIdx.x / lanes; row < rows; row += LIST_ORDER_BLOCK / lanes) {
    uint64_t begin = uint64_t(buf.list_begin[i + row]) + written;
    uint s = uint(buf.list_place[element_of(buf, i + row)].w);
    uint first_point = buf.list_system[s].first_point;
    uint key_bits = buf.list_system[s].key_bits;
    uint length = lengths[row];
    for (uint n = threadIdx.x % lanes; n < length; n += lanes) {
      uint j = first_point + (key_at(row, bits, n) >> key_bits);
      if ((flags & LIST_WANTS_FIRST) != 0u) buf.list_first[column_index(begin) + n] = i + row;
      if ((flags & LIST_WANTS_SECOND) != 0u) buf.list_second[column_index(begin) + n] = j;
    }
    if ((flags & LIST_WANTS_SHIFTS) != 0u) write_shifts(buf, i + row, row, bits, begin, lanes);
  }
  __syncthreads();
}

// Rows of which none is longer than 2^bits threads can sort.
__device__ inline void order_rows(const KernelBuffers& buf, uint first, uint rows, uint bits) {
  uint thread = threadIdx.x;
  uint row = thread >> bits;
  uint lane = thread & ((1u << bits) - 1u);
  for (uint turn = 0u; turn < rows; turn += LIST_ORDER_BLOCK >> bits) {
    uint here = min(rows - turn, LIST_ORDER_BLOCK >> bits);
    uint i = first + turn + min(row, here - 1u);
    uint length = row < here ? buf.row_length[i] : 0u;
    uint64_t from = keys_at(buf, i, length);
    OwnKeys own;
#pragma unroll  // CUDA only: as above
    for (uint r = 0u; r < LIST_KEYS_EACH; ++r) {
      uint n = (r << bits) + lane;
      own.of[r] = n < length ? buf.list_keys[column_index(from + uint64_t(n))] : ~0u;
    }
    if (lane == 0u) lengths[row] = length;
    sort_rows(own, bits);
    write_rows(buf, first + turn, here, bits, uint64_t(0u));
  }
}

// Copies the keys low <= key < high to shared memory, LIST_MOST_KEYS at most. Returns how many there are.
__device__ inline uint keys_between(const KernelBuffers& buf, uint64_t first, uint length, uint64_t low,
                                    uint64_t high) {
  __syncthreads();
  if (threadIdx.x == 0u) found = 0u;
  __syncthreads();
  for (uint k = threadIdx.x; k < length; k += LIST_ORDER_BLOCK) {
    uint key = buf.list_keys[column_index(first + uint64_t(k))];
    if (uint64_t(key) < low || uint64_t(key) >= high) continue;
    uint n = atomicAdd(&found, 1u);
    if (n < LIST_MOST_KEYS) keys[n] = key;
  }
  __syncthreads();
  return found;
}

__device__ inline void order_long_row(const KernelBuffers& buf, uint i) {
  uint length = buf.row_length[i];
  uint64_t first = keys_at(buf, i, length);
  RowKeys row = keys_of_row(buf, i);
  uint64_t step = uint64_t(buf.list_state[0].points) << row.bits;
  uint64_t low = uint64_t(0u);
  uint64_t written = uint64_t(0u);
  while (written < uint64_t(length)) {
    uint count = keys_between(buf, first, length, low, low + step);
    if (count > LIST_MOST_KEYS) {
      step = step >> 1;
      continue;
    }
    OwnKeys own;
#pragma unroll  // CUDA only: as above
    for (uint r = 0u; r < LIST_KEYS_EACH; ++r) {
      uint n = r * 32u + threadIdx.x;
      own.of[r] = threadIdx.x < 32u && n < count ? keys[n] : ~0u;
    }
    __syncthreads();
    if (threadIdx.x == 0u) lengths[0] = count;
    sort_rows(own, LIST_MOST_BITS);
    write_rows(buf, i, 1u, LIST_MOST_BITS, written);
    written += uint64_t(count);
    low += step;
    if (count < LIST_MOST_KEYS / 4u) step = step << 1;
  }
}

__global__ void __launch_bounds__(LIST_ORDER_BLOCK) list_order(Params p, KernelBuffers buf) {
  wait_first(p);  // CUDA only: it gets ready early
  uint looking = buf.list_state[0].looking;
  uint first = group_index(p) << buf.list_state[0].order_bits;
  if (first >= looking || !is_right(buf) || !has_room(buf)) return;
  uint rows = min(1u << buf.list_state[0].order_bits, looking - first);
  uint thread = threadIdx.x;
  if (thread == 0u) longest = 0u;
  __syncthreads();
  if (thread < rows) atomicMax(&longest, buf.row_length[first + thread]);
  __syncthreads();
  uint most = longest;
  uint bits = 0u;
  while (bits < LIST_MOST_BITS && most > LIST_KEYS_EACH << bits) ++bits;
  if (most <= LIST_MOST_KEYS) {
    order_rows(buf, first, rows, bits);
  } else {
    for (uint row = 0u; row < rows; ++row) {
      if (buf.row_length[first + row] <= LIST_MOST_KEYS) {
        order_rows(buf, first + row, 1u, LIST_MOST_BITS);
      } else {
        order_long_row(buf, first + row);
      }
    }
  }
}

Entry list_order_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_order); }

}  // namespace spherepair
