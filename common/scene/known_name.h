// SPDX-License-Identifier: MIT
// What is said of a name that is not among the known ones.
#pragma once

#include <string>
#include <vector>

namespace spherepair {

// The known name that is fewest edits away (a letter inserted, left out, replaced or swapped with the next), at most
// one for every three letters; else the first that holds all of the name; else an empty string.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

// unknown method 'collide_gird'; did you mean collide_grid? Known are ...
std::string unknown_name(const std::string& what, const std::string& name, const std::vector<std::string>& known);

}  // namespace spherepair
