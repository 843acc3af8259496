// SPDX-License-Identifier: MIT
// One thread per row of the list, or several where there are few rows: counts its pairs. Threads of one row take rows
// of cells in turns. A thread that finds an undecided pair looks again, and decides on the numbers as given.
#include "cuda/list/list_row.cuh"

namespace spherepair {

__shared__ uint found[LIST_BLOCK];

// The number of pairs; in y not 0 if some are undecided. Keeps the points that it finds for list_find.
__device__ inline uvec2 pairs_of(const KernelBuffers& buf, ListLook look, uint lane, uint lanes, uint thread,
                                 bool exact) {
  bool all = lists_all(buf);
  uint threads = buf.list_state[0].looking * lanes;
  uint word = 0u;
  uvec2 pairs = uvec2{0u, 0u};
  uint z = 0u;
  for (uint y = lane; true; y += lanes) {
    for (; y >= look.along_y; y -= look.along_y) ++z;
    if (z >= look.along_z) return pairs;
    CellRow row = row_at(buf, look, y, z);
    while (row.left != 0u) {
      row = next_range(buf, look, row);
      for (uint at = row.begin; at < row.end; at += 32u) {
        uvec2 listed = listed_points(buf, look, row, at, min(at + 32u, row.end), all, exact);
        if (word < buf.list_state[0].mask_words) buf.list_masks[word * threads + thread] = listed.x;
        ++word;
        pairs = uvec2{pairs.x + count_bits(listed.x), pairs.y | listed.y};
      }
    }
  }
  return pairs;
}

__global__ void __launch_bounds__(LIST_BLOCK, 8) list_count(Params p, KernelBuffers buf) {
  if (!is_right(buf)) return;
  uint thread = threadIdx.x;
  uint bits = buf.list_state[0].row_bits;
  uint k = (group_index(p) * LIST_BLOCK + thread) >> bits;
  uint lanes = 1u << bits;
  uint lane = thread & (lanes - 1u);
  bool looks = k < buf.list_state[0].looking;
  found[thread] = 0u;
  __syncthreads();
  if (looks) {
    uvec2 pairs = pairs_of(buf, buf.list_look[k], lane, lanes, k * lanes + lane, false);
    if (pairs.y != 0u) pairs = pairs_of(buf, buf.list_look[k], lane, lanes, k * lanes + lane, true);
    if (pairs.x != 0u) atomicAdd(&found[thread >> bits], pairs.x);
  }
  __syncthreads();
  if (looks && lane == 0u) buf.row_length[buf.list_look[k].i] = found[thread >> bits];
}

Entry list_count_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_count); }

}  // namespace spherepair
