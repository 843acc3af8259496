// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace spherepair {

// Returns the text of every shader by file name, with its includes inserted.
const std::map<std::string, std::string>& embedded_shaders();

}  // namespace spherepair
