// SPDX-License-Identifier: MIT
// Which kernels take part in programmatic dependent launches.
#pragma once

#include "common/device/launch.h"

namespace spherepair {

// Up to so many spheres the kernels of all pairs gain by getting ready early. Of more, groups that are resident early
// are spread over the multiprocessors less evenly: 4,096 spheres take 8.9 us a step instead of 8.1.
inline constexpr uint early_spheres = 2048;

// Whether the kernel gets ready while the launch before it is under way, and waits for that first.
inline bool waits_first(const Launch& launch, const Params& params) {
  switch (launch.kernel) {
    case Kernel::grid_sort:
    case Kernel::collide_grid:
    case Kernel::empty:
      return true;
    case Kernel::move:
    case Kernel::collide_triangle:
      return params.n <= early_spheres;
    default:
      return false;
  }
}

// Whether the kernel waits in its last line for the launch before it, if that may still be under way.
inline bool waits_last(Kernel kernel) {
  return kernel == Kernel::split_tiles || kernel == Kernel::move || kernel == Kernel::bounce;
}

}  // namespace spherepair
