// SPDX-License-Identifier: MIT
#pragma once

#include "common/device/launch.h"
#include "cuda/kernels.h"

namespace spherepair {

// The compiled kernel that a launch asks for; null when its group size was not compiled.
Entry entry_of(const Launch& launch);

}  // namespace spherepair
