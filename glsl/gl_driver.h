// SPDX-License-Identifier: MIT
// What the driver of the current context says of itself.
#pragma once

#include <string>

#include "backend.h"
#include "program.h"

namespace spherepair {

std::string gl_string(GLenum name);
Features driver_features();
BackendInfo describe_driver(bool software, bool sparse, Features features);

}  // namespace spherepair
