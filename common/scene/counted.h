// SPDX-License-Identifier: MIT
// Counts with their nouns, for people to read.
#pragma once

#include <cstdint>
#include <string>

namespace spherepair {

// Returns "1 sphere" or "2 spheres". many: the plural, if it does not end in s.
inline std::string counted(uint64_t n, const std::string& one, const std::string& many = "") {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace spherepair
