// SPDX-License-Identifier: MIT
// All pairs through tensor cores: the launches of collide_tensor and of what it needs.
#pragma once

#include "common/simulation/motion/context.h"

namespace spherepair {

// For a device with tensor_groups. Its forms take the buffers of the sort into cells.
void launch_tensor_pairs(DeviceContext& context, const Variant& variant);

}  // namespace spherepair
