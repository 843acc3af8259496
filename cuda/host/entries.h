// SPDX-License-Identifier: MIT
#pragma once

#include "common/device/launch.h"
#include "cuda/kernels.h"

namespace spherepair {

// Returns the compiled kernel for a launch; null if its group size was not compiled.
Entry entry_of(const Launch& launch);

}  // namespace spherepair
