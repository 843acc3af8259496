// SPDX-License-Identifier: MIT
// Writes images as PNG files.
#pragma once

#include <filesystem>
#include <span>

#include "common/shared/layout.h"

namespace spherepair {

// Pixels in the format of Drawing::image(). Throws std::invalid_argument if the file cannot be written.
void write_png(const std::filesystem::path& path, std::span<const uint> pixels, uint width, uint height);

}  // namespace spherepair
