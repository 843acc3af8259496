// SPDX-License-Identifier: MIT
// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <span>

#include "common/shared/layout.h"

namespace spherepair {

// Pixels as Backend::image() gives them. Throws std::invalid_argument when the file cannot be written.
void write_png(const std::filesystem::path& path, std::span<const uint> pixels, uint width, uint height);

}  // namespace spherepair
