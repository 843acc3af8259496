// SPDX-License-Identifier: MIT
// The searches without a grid: which groups of a kernel test which pairs.
#pragma once

#include "common/device/context.h"

namespace spherepair {

// Columns that one group of collide_triangle tests against its rows, where the options leave that open.
uint default_columns(uint64_t n, bool software);

// Launches the method's kernel for all pairs, in slices that a driver lets run. Throws std::invalid_argument for a
// method that devices do not have.
void launch_all_pairs(DeviceContext& context, const CollideOptions& options, const Variant& variant);

// The same through tensor cores, for a device with tensor_groups: collide_tensor and what it needs, whose forms take
// the buffers of the sort into cells.
void launch_tensor_pairs(DeviceContext& context, const Variant& variant);

}  // namespace spherepair
