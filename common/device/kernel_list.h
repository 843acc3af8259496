// SPDX-License-Identifier: MIT
// Every kernel, by the name that its two source files, its stage in the results and its entry in CUDA have in common.
#pragma once

// clang-format off
#define SPHEREPAIR_KERNELS(each)                                                                \
  each(move) each(bounce) each(place) each(clear) each(sample) each(empty)                      \
  each(ceiling_copy) each(ceiling_atomics) each(ceiling_issue) each(ceiling_words)              \
  each(settle) each(decide) each(tally)                                                         \
  each(grid_clear) each(grid_bounds) each(grid_count) each(grid_sums) each(grid_scan)           \
  each(grid_scatter) each(split_tiles) each(split_count) each(split_scan) each(grid_split)      \
  each(grid_sort)                                                                               \
  each(collide_grid) each(collide_hashed) each(collide_group) each(collide_tiled)               \
  each(collide_swept) each(collide_square) each(collide_triangle)                               \
  each(draw_clear) each(draw_counts) each(draw_bounds) each(draw_cull) each(draw_pyramid)       \
  each(draw_seen) each(draw_clusters) each(draw_spheres) each(draw_tiles) each(draw_resolve)    \
  each(draw_light)
// clang-format on
