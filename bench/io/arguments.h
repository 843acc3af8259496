// SPDX-License-Identifier: MIT
// Checks and parses option values. Each throws std::invalid_argument with the known values.
#pragma once

#include <string>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

void require_known(const std::string& what, const std::string& name, const std::vector<std::string>& known);
std::vector<std::string> backend_ids(std::vector<std::string> names);  // see backend_id

std::vector<Method> all_methods();
std::vector<Method> parse_methods(const std::vector<std::string>& names);  // all when empty
std::vector<uint> parse_blocks(const std::vector<uint>& blocks);           // all when empty

}  // namespace spherepair
