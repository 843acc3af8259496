// SPDX-License-Identifier: MIT
// What the driver of the current context says of itself.
#pragma once

#include <string>

#include "backend.h"
#include "program.h"

namespace spherepair {

void require_gl_features();  // throws BackendError naming the first that the kernels need and the driver lacks
Features driver_features();
BackendInfo describe_driver(bool software, bool sparse, Features features);

}  // namespace spherepair
