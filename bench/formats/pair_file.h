// SPDX-License-Identifier: MIT
// Colliding pairs as a file: NPY (m x 2, uint32, C order) or text, a line `i j` each, by the file's extension.
#pragma once

#include <span>
#include <string>

#include "common/scene/pair_set.h"

namespace spherepair {

inline constexpr const char* kStandardOutput = "-";  // as text

// Throws std::invalid_argument for an extension that is not known.
void check_pair_file(const std::string& file);

// The file appears whole or not at all.
void write_pairs(const std::string& file, std::span<const Pair> pairs);

}  // namespace spherepair
