// SPDX-License-Identifier: MIT
// Numbers with their noun, in text for people.
#pragma once

#include <cstdint>
#include <string>

namespace spherepair {

// "1 sphere", "2 spheres"; a plural that does not end in s is given.
inline std::string counted(uint64_t n, const std::string& one, const std::string& many = "") {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace spherepair
