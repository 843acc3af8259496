// SPDX-License-Identifier: MIT
// What every kernel gets, and where the host finds the kernels: one entry per file, by group size and variant.
#pragma once

#include "layout.h"
#include "variant.h"

namespace spherepair {

// The buffers of layout.h, by slot.
struct World {
  vec4* position;
  vec4* velocity;
  uint* count;
  uint* summary;
  uvec2* deferred;
  uvec2* listed;
  const vec4* spheres;
  uint* verdict;
  uint* cell;
  const uint* from_id;
  vec4* sorted;
  uint* id;
  uint* sorted_count;
  uint* tile_sum;
  uint* next_place;
  uvec2* visible;
  uint* image;
  uvec2* tile;
  uint* drawn;
  vec4* cluster;
  uint* cluster_seen;
  uint* cluster_list;
  uint* pyramid;
  void* wide;  // Real[]
  const vec4* anchor;
  void* flight;  // Real[]
  uint* since;
  uint* due;
};

// Every kernel is void (Params p, World w), those that draw take a View v beside. A null entry means a group size that
// was not compiled.
using Entry = const void*;
Entry move_kernel(Variant variant);
Entry bounce_kernel(Variant variant);
Entry place_kernel(Variant variant);
Entry clear_kernel();
Entry empty_kernel();
Entry ceiling_copy_kernel();
Entry ceiling_atomics_kernel();
Entry ceiling_issue_kernel();
Entry settle_kernel(Variant variant);
Entry decide_kernel();
Entry tally_kernel();
Entry grid_clear_kernel();
Entry grid_bounds_kernel();
Entry split_count_kernel();
Entry split_scan_kernel();
Entry grid_split_kernel();
Entry grid_sort_kernel();
Entry grid_count_kernel();
Entry grid_sums_kernel();
Entry grid_scan_kernel();
Entry grid_scatter_kernel();
Entry collide_grid_kernel(uint block, Variant variant);
Entry collide_hashed_kernel(uint block, Variant variant);
Entry collide_group_kernel(uint block, Variant variant);
Entry collide_tiled_kernel(uint block, Variant variant);
Entry collide_swept_kernel(uint block, Variant variant);
Entry collide_square_kernel(uint block, Variant variant);
Entry collide_triangle_kernel(uint block, Variant variant);
Entry draw_clear_kernel();
Entry draw_counts_kernel();
Entry draw_bounds_kernel();
Entry draw_cull_kernel();
Entry draw_pyramid_kernel();
Entry draw_clusters_kernel();
Entry draw_spheres_kernel();
Entry draw_tiles_kernel();
Entry draw_resolve_kernel();
Entry draw_light_kernel();

}  // namespace spherepair
