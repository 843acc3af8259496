// SPDX-License-Identifier: MIT
#include "entries.h"

namespace spherepair {

Entry entry_of(const Launch& launch) {
  switch (launch.kernel) {
    case Kernel::move:
      return move_kernel(launch.variant);
    case Kernel::bounce:
      return bounce_kernel(launch.variant);
    case Kernel::place:
      return place_kernel(launch.variant);
    case Kernel::clear:
      return clear_kernel();
    case Kernel::empty:
      return empty_kernel();
    case Kernel::ceiling_copy:
      return ceiling_copy_kernel();
    case Kernel::ceiling_atomics:
      return ceiling_atomics_kernel();
    case Kernel::ceiling_issue:
      return ceiling_issue_kernel();
    case Kernel::settle:
      return settle_kernel(launch.variant);
    case Kernel::decide:
      return decide_kernel();
    case Kernel::tally:
      return tally_kernel();
    case Kernel::grid_clear:
      return grid_clear_kernel();
    case Kernel::grid_bounds:
      return grid_bounds_kernel();
    case Kernel::split_count:
      return split_count_kernel();
    case Kernel::split_scan:
      return split_scan_kernel();
    case Kernel::grid_split:
      return grid_split_kernel();
    case Kernel::grid_sort:
      return grid_sort_kernel();
    case Kernel::grid_count:
      return grid_count_kernel();
    case Kernel::grid_sums:
      return grid_sums_kernel();
    case Kernel::grid_scan:
      return grid_scan_kernel();
    case Kernel::grid_scatter:
      return grid_scatter_kernel();
    case Kernel::collide_grid:
      return collide_grid_kernel(launch.block, launch.variant);
    case Kernel::collide_hashed:
      return collide_hashed_kernel(launch.block, launch.variant);
    case Kernel::collide_group:
      return collide_group_kernel(launch.block, launch.variant);
    case Kernel::collide_tiled:
      return collide_tiled_kernel(launch.block, launch.variant);
    case Kernel::collide_swept:
      return collide_swept_kernel(launch.block, launch.variant);
    case Kernel::collide_square:
      return collide_square_kernel(launch.block, launch.variant);
    case Kernel::collide_triangle:
      return collide_triangle_kernel(launch.block, launch.variant);
    case Kernel::draw_clear:
      return draw_clear_kernel();
    case Kernel::draw_counts:
      return draw_counts_kernel();
    case Kernel::draw_bounds:
      return draw_bounds_kernel();
    case Kernel::draw_cull:
      return draw_cull_kernel();
    case Kernel::draw_pyramid:
      return draw_pyramid_kernel();
    case Kernel::draw_clusters:
      return draw_clusters_kernel();
    case Kernel::draw_spheres:
      return draw_spheres_kernel();
    case Kernel::draw_tiles:
      return draw_tiles_kernel();
    case Kernel::draw_resolve:
      return draw_resolve_kernel();
    case Kernel::draw_light:
      return draw_light_kernel();
  }
  return nullptr;
}

}  // namespace spherepair
