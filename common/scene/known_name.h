// SPDX-License-Identifier: MIT
// Messages for names that are not known.
#pragma once

#include <string>
#include <vector>

namespace spherepair {

// Returns the known name that is fewest edits away (a letter inserted, left out, replaced or swapped with the next), at
// most one for every three letters. Else the first known name that contains `name`, else an empty string.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

// Returns a message such as: unknown method 'collide_gird'; did you mean collide_grid? Known are ...
std::string unknown_name(const std::string& what, const std::string& name, const std::vector<std::string>& known);

}  // namespace spherepair
