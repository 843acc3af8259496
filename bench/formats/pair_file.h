// SPDX-License-Identifier: MIT
// Writes colliding pairs as NPY (m x 2, uint32, C order) or text (lines `i j`), by the file's extension.
#pragma once

#include <span>
#include <string>

#include "bench/formats/files.h"
#include "common/scene/pair_set.h"

namespace spherepair {

// Throws std::invalid_argument for an unknown extension.
void check_pair_file(const std::string& file);

// Replaces the file atomically.
void write_pairs(const std::string& file, std::span<const Pair> pairs);

}  // namespace spherepair
