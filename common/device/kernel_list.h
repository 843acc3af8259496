// SPDX-License-Identifier: MIT
// A row for every kernel: its name, which its source files, its stage in the results and its entry in CUDA share, and
// the buffers that it reads and writes in any variant. Devices place waits between launches by this table; the lint
// compares it with the shaders. Only Vulkan and CUDA have the tensor kernels, only CUDA has persistent_steps. OpenGL
// and software run the kernels of lists only in tests (docs/NOTES/lists.md).
#pragma once

// clang-format off
#define SPHEREPAIR_MIRRORED_KERNELS(each) \
  each(move, position | velocity | wide, position | velocity | count | summary | wide) \
  each(bounce, velocity | anchor | flight | since | next_event, flight | since | next_event) \
  each(evaluate_positions, velocity | anchor | flight | since, position | velocity | count | summary | wide) \
  each(contact_grow, position | axis | fault | image_of, grown | fault | rest | image_of) \
  each(contact_images, near | image_of, near) \
  each(contact_pairs, position | axis | impulse | near | fault | rest, impulse | fault | rest) \
  each(leapfrog, position | axis | impulse | grown | fault | rest, \
       position | velocity | count | summary | axis | impulse | fault | rest) \
  each(clear, none, count | summary) \
  each(sample, position, sorted) \
  each(empty, none, none) \
  each(peak_copy, position, velocity) \
  each(peak_atomics, count, count) \
  each(peak_issue, position, velocity) \
  each(peak_words, position, velocity) \
  each(resolve_undecided, position | count | summary | deferred | id, count | summary | listed) \
  each(decide, spheres, verdict) \
  each(tally, count | summary, summary) \
  each(grid_clear, none, summary | cell | bucket_cursor) \
  each(grid_bounds, position, count | summary | cell | tile_sum) \
  each(grid_count, position | cell, cell) \
  each(grid_sums, cell, tile_sum) \
  each(grid_scan, cell | tile_sum, cell) \
  each(grid_scatter, position | cell, cell | sorted | id | sorted_count) \
  each(split_tiles, position, sorted | id | bucket_cursor) \
  each(split_count, position | bucket_cursor, bucket_cursor) \
  each(split_scan, bucket_cursor, bucket_cursor) \
  each(grid_split, position | from_id | bucket_cursor, sorted | id | bucket_cursor) \
  each(grid_sort, position | from_id | bucket_cursor, summary | cell | sorted | id | sorted_count) \
  each(collide_grid, position | count | summary | cell | id, count | summary | deferred | listed) \
  each(collide_hashed, position | count | summary | cell | id, count | summary | deferred | listed) \
  each(collide_group, position | count | summary, count | summary | deferred | listed) \
  each(collide_tiled, position | count | summary, count | summary | deferred | listed) \
  each(collide_swept, position | count | summary | grown | near, count | summary | listed) \
  each(collide_images, position | count | summary | near, count | summary | listed) \
  each(collide_square, position | count | summary, count | summary | deferred | listed) \
  each(collide_triangle, position | count | summary | id, count | summary | deferred | listed) \
  each(draw_clear, visible | drawn | seen_left, visible | drawn | seen_left | seen_list) \
  each(draw_unsort_counts, sorted | id | sorted_count, count) \
  each(draw_colours, position | velocity, colour) \
  each(draw_bounds, position, cluster) \
  each(draw_cull, drawn | cluster | cluster_list | pyramid, drawn | cluster | cluster_list) \
  each(draw_hiz_pyramid, visible | drawn, drawn | pyramid) \
  each(draw_previously_visible, position | id | sorted_count | visible | drawn | seen_left | pyramid | seen_list, \
       count | visible | tile | drawn | seen_left | seen_list) \
  each(draw_clusters, position | id | sorted_count | visible | drawn | seen_left | cluster_list | pyramid, \
       count | visible | tile | drawn) \
  each(draw_spheres, position | id | sorted_count | visible | drawn | seen_left | pyramid, \
       count | visible | tile | drawn) \
  each(draw_tiles, position | visible | tile | drawn | pyramid, visible) \
  each(draw_resolve, position | count | visible | drawn | seen_left, \
       visible | image | drawn | seen_left | seen_list) \
  each(draw_light, position | count | cell | sorted | id | visible, image)
#define SPHEREPAIR_LIST_KERNELS(each) \
  each(list_clear, list_state, list_state | list_system | cell) \
  each(list_measure, list_state | list_system | list_given, list_state | list_system | list_place) \
  each(list_plan, list_state | list_system, list_state | list_system) \
  each(list_bin, cell | list_state | list_system | list_given | list_place, cell | list_bins) \
  each(list_scatter, cell | list_state | list_bins, id) \
  each(list_look, id | list_state | list_system | list_given | list_place, sorted | list_look) \
  each(list_prepare, list_state | list_system | list_given | list_place | list_bins, \
       list_state | list_system | list_place | list_bins | cell | id | sorted | list_look) \
  each(list_count, cell | sorted | id | list_state | list_system | list_given | list_place | list_look | list_excluded, \
       row_length | list_keys | list_state | list_long) \
  each(list_sums, row_length | list_state, list_sum) \
  each(list_scan, row_length | list_state | list_sum, list_begin) \
  each(list_find, \
       cell | sorted | id | list_state | list_system | list_given | list_place | list_look | list_excluded | \
           row_length | list_begin | list_long, \
       list_keys) \
  each(list_order, list_state | list_system | list_place | row_length | list_begin | list_keys, \
       list_first | list_second | list_shift)
#define SPHEREPAIR_TENSOR_KERNELS(each) \
  each(tensor_bounds, position, tile_sum) \
  each(tensor_forms, position | tile_sum, sorted) \
  each(collide_tensor, position | count | summary | sorted | id, count | summary | deferred | listed)
#define SPHEREPAIR_CUDA_KERNELS(each) \
  each(persistent_steps, position | velocity | count | summary, \
       position | velocity | count | summary | deferred | listed)
#define SPHEREPAIR_KERNELS(each) \
  SPHEREPAIR_MIRRORED_KERNELS(each) SPHEREPAIR_LIST_KERNELS(each) SPHEREPAIR_TENSOR_KERNELS(each) \
  SPHEREPAIR_CUDA_KERNELS(each)
// clang-format on
