// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace spherepair {

// The flattened text of every shader, by file name.
const std::map<std::string, std::string>& embedded_shaders();

}  // namespace spherepair
