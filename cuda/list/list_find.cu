// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows, as in list_count: writes the keys of its pairs,
// in any order.
#include "cuda/list/list_length.cuh"
#include "cuda/list/list_row.cuh"

namespace spherepair {

__shared__ uint found[LIST_BLOCK];

// The number of an image, which the key of a pair ends with.
__device__ inline uint number_of_image(const KernelBuffers& buf, uint s, ivec4 image) {
  uint x = uint(image.x + int(buf.list_system[s].images[0]));
  uint y = uint(image.y + int(buf.list_system[s].images[1]));
  uint z = uint(image.z + int(buf.list_system[s].images[2]));
  return (x * (2u * buf.list_system[s].images[1] + 1u) + y) * (2u * buf.list_system[s].images[2] + 1u) + z;
}

__device__ inline void write_keys(const KernelBuffers& buf, ListLook look, CellRow row, uint end, uint listed,
                                  uint length, uint group_row) {
  uint n = atomicAdd(&found[group_row], count_bits(listed));
  uint64_t first = uint64_t(buf.list_begin[look.i]);
  uint first_point = buf.list_system[look.system].first_point;
  uint key_bits = buf.list_system[look.system].key_bits;
  uint number = number_of_image(buf, look.system, row.image);
  for (; listed != 0u && n < length; ++n) {
    uint j = buf.id[end - 1u - lowest_bit(listed)];
    buf.list_keys[column_index(first + uint64_t(n))] = (j - first_point) << key_bits | number;
    listed &= listed - 1u;
  }
}

// Writes the pairs in the masks of list_count, and looks for those that the masks had no room for. With `exact` it
// writes only pairs outside the masks that float32 leaves undecided. Returns whether there may be such pairs.
__device__ inline bool find_pairs(const KernelBuffers& buf, ListLook look, uint lane, uint lanes, uint thread,
                                  uint group_row, bool exact) {
  bool all = lists_all(buf);
  uint threads = buf.list_state[0].looking * lanes;
  uint word = 0u;
  uint length = buf.row_length[look.i];
  uint undecided = 0u;
  uint z = 0u;
  for (uint y = lane; true; y += lanes) {
    for (; y >= look.along_y; y -= look.along_y) ++z;
    if (z >= look.along_z) return undecided != 0u;
    CellRow row = row_at(buf, look, y, z);
    while (row.left != 0u) {
      row = next_range(buf, look, row);
      for (uint at = row.begin; at < row.end; at += 32u) {
        uint end = min(at + 32u, row.end);
        uvec2 listed = uvec2{0u, 0u};
        if (word >= buf.list_state[0].mask_words) {
          listed = listed_points(buf, look, row, at, end, all, exact);
          undecided |= listed.y;
          if (exact) listed.x &= listed.y;
        } else if (!exact) {
          listed.x = buf.list_masks[word * threads + thread];
        }
        ++word;
        if (listed.x != 0u) write_keys(buf, look, row, end, listed.x, length, group_row);
      }
    }
  }
  return false;
}

__global__ void __launch_bounds__(LIST_BLOCK, 8) list_find(Params p, KernelBuffers buf) {
  if (!is_right(buf) || !has_room(buf)) return;
  uint thread = threadIdx.x;
  uint bits = buf.list_state[0].row_bits;
  uint k = (group_index(p) * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  found[thread] = 0u;
  __syncthreads();
  uint lane = thread & (lanes - 1u);
  if (k >= buf.list_state[0].looking) return;
  uint own = k * lanes + lane;
  if (find_pairs(buf, buf.list_look[k], lane, lanes, own, thread >> bits, false))
    find_pairs(buf, buf.list_look[k], lane, lanes, own, thread >> bits, true);
}

Entry list_find_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_find); }

}  // namespace spherepair
