// SPDX-License-Identifier: MIT
// Searches without a grid: which groups of a kernel test which pairs.
#pragma once

#include "common/device/context.h"

namespace spherepair {

// Returns how many columns a group of collide_triangle tests if the options leave it open.
uint default_columns(uint64_t n, bool software);

// Launches the method's kernel for all pairs, in slices short enough for a driver. Throws std::invalid_argument for a
// method that devices do not have.
void launch_all_pairs(DeviceContext& context, const CollideOptions& options, const Variant& variant);

// Launches collide_tensor and its preparation, on a device with tensor_groups. The forms of spheres use the buffers of
// the sort into cells.
void launch_tensor_pairs(DeviceContext& context, const Variant& variant);

}  // namespace spherepair
