// SPDX-License-Identifier: MIT
// Chooses the kernels that take part in programmatic dependent launches.
#pragma once

#include "common/device/launch.h"

namespace spherepair {

// Up to this many spheres, kernels of all pairs gain by getting ready early. With more, groups that are resident early
// are spread over the multiprocessors less evenly: 4,096 spheres take 8.9 us a step instead of 8.1.
inline constexpr uint early_spheres = 2048;

// Whether the kernel gets ready while the previous launch still runs, and waits for that first.
inline bool waits_first(const Launch& launch, const Params& params) {
  switch (launch.kernel) {
    case Kernel::grid_sort:
    case Kernel::collide_grid:
    case Kernel::empty:
    case Kernel::list_count:
    case Kernel::list_sums:
    case Kernel::list_scan:
    case Kernel::list_find:
    case Kernel::list_order:
      return true;
    case Kernel::move:
    case Kernel::collide_triangle:
      return params.n <= early_spheres;
    default:
      return false;
  }
}

// Whether the kernel waits in its last line for the previous launch, if that may still run.
inline bool waits_last(Kernel kernel) {
  return kernel == Kernel::split_tiles || kernel == Kernel::move || kernel == Kernel::bounce;
}

}  // namespace spherepair
