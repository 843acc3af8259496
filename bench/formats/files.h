// SPDX-License-Identifier: MIT
// Reads and writes files. Each throws std::invalid_argument naming the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace spherepair {

// Replaces a regular file atomically (ReplacedFile).
void write_file(const std::filesystem::path& path, const std::string& text);

// Creates the folder and checks that these files can be written in it.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& files);

// One sphere per line, `x y z radius [vx vy vz]`; # starts a comment. A malformed line is refused with its number.
Scene read_spheres(const std::filesystem::path& path);

}  // namespace spherepair
