// SPDX-License-Identifier: MIT
// What the current context's driver offers.
#pragma once

#include "backend.h"

namespace spherepair {

void require_gl_features();  // throws BackendError naming the first that the kernels need and the driver lacks
BackendInfo gl_info(bool software);

}  // namespace spherepair
