// SPDX-License-Identifier: MIT
// Files in and out. Each throws std::invalid_argument that names the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace spherepair {

// A regular file is replaced whole or not at all: written beside it first, then renamed.
void write_file(const std::filesystem::path& path, const std::string& text);

// Creates the folder and checks that these files can be written in it.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& files);

// A line per sphere, `x y z radius [vx vy vz]`; # starts a comment. Other lines are refused by their number.
Scene read_spheres(const std::filesystem::path& path);

}  // namespace spherepair
