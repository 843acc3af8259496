// SPDX-License-Identifier: MIT
// Runs whole steps in one launch: in each, one thread per sphere moves it by `paper` and clears the last results, then
// the groups share the pairs of BLOCK rows and p.search.columns_per_group columns, a thread a row. All groups run at
// once and wait for each other after either part. Undecided pairs are kept of the last step only.
//
// CUDA only: OpenGL has no barrier of all groups of a dispatch
#include <cooperative_groups.h>

#include "cuda/collide/collide.cuh"
#include "cuda/motion/motion_state.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__device__ inline void move_spheres(const Params& p, const KernelBuffers& buf) {
  uint threads = max(p.n, uint(SUMMARY_SLOTS * SUMMARY_WORDS));
  for (uint i = blockIdx.x * BLOCK + threadIdx.x; i < threads; i += gridDim.x * BLOCK) {
    clear_results(p, buf, i);
    if (i < p.n) store_sphere(p, buf, i, take_step(MOTION_PAPER, load_sphere<float>(p, buf, i), p.motion));
  }
}

template <bool EQUAL_RADII>
__device__ void test_pairs(const Params& p, const KernelBuffers& buf) {
  Collider<EQUAL_RADII, false> collider(p, buf);
  collider.start_totals();
  uint columns = p.search.columns_per_group;
  uint64_t across = (p.n + columns - 1u) / columns, down = (p.n + BLOCK - 1u) / BLOCK;
  for (uint64_t part = blockIdx.x; part < across * down; part += gridDim.x) {
    uint first_row = uint(part / across) * BLOCK, first_column = uint(part % across) * columns;
    uint end = min(first_column + columns, p.n);
    if (end <= first_row + 1u) continue;  // each pair once, by the row that comes first
    uint i = first_row + threadIdx.x;
    vec4 row = buf.position[min(i, p.n - 1u)];
    for (uint j = first_column; j < end; ++j)
      if (i < j && collider.in_reach(row, buf.position[j])) collider.test_stored_pair(i, j);
  }
  collider.finish_totals();
}

template <bool EQUAL_RADII>
__global__ void __launch_bounds__(BLOCK) persistent_steps(Params p, KernelBuffers buf, uint steps) {
  cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  for (uint step = 0u; step < steps; ++step) {
    move_spheres(p, buf);
    grid.sync();
    test_pairs<EQUAL_RADII>(p, buf);
    grid.sync();
  }
}

Entry persistent_steps_kernel(uint, Variant variant) {
  return variant.equal_radii ? reinterpret_cast<Entry>(&persistent_steps<true>)
                             : reinterpret_cast<Entry>(&persistent_steps<false>);
}

}  // namespace spherepair
