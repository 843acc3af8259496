// SPDX-License-Identifier: MIT
// Every kernel, by the name that its source files, its stage in the results and its entry in CUDA have in common.
#pragma once

// clang-format off
#define SPHEREPAIR_MIRRORED_KERNELS(each)                                                       \
  each(move) each(bounce) each(evaluate_positions) each(contact_grow) each(contact_pairs) each(leapfrog)     \
  each(contact_rows) each(contact_order) each(contact_gather)                                                \
  each(clear) each(sample) each(empty)                                                                       \
  each(peak_copy) each(peak_atomics) each(peak_issue) each(peak_words)              \
  each(resolve_undecided) each(decide) each(tally)                                                         \
  each(grid_clear) each(grid_bounds) each(grid_count) each(grid_sums) each(grid_scan)           \
  each(grid_scatter) each(split_tiles) each(split_count) each(split_scan) each(grid_split)      \
  each(grid_sort)                                                                               \
  each(collide_grid) each(collide_hashed) each(collide_group) each(collide_tiled)               \
  each(collide_swept) each(collide_square) each(collide_triangle)                               \
  each(draw_clear) each(draw_unsort_counts) each(draw_colours) each(draw_bounds) each(draw_cull) each(draw_hiz_pyramid)       \
  each(draw_previously_visible) each(draw_clusters) each(draw_spheres) each(draw_tiles) each(draw_resolve)    \
  each(draw_light)
#define SPHEREPAIR_CUDA_KERNELS(each) each(tensor_bounds) each(tensor_forms) each(collide_tensor) each(persistent_steps)
#define SPHEREPAIR_KERNELS(each) SPHEREPAIR_MIRRORED_KERNELS(each) SPHEREPAIR_CUDA_KERNELS(each)
// clang-format on
