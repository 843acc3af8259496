// SPDX-License-Identifier: MIT
// Files in and out. Each throws std::invalid_argument that names the file and the reason.
#pragma once

#include <filesystem>
#include <string>

#include "scene.h"

namespace spherepair {

// A regular file is replaced whole or not at all: written beside it first, then renamed.
void write_file(const std::filesystem::path& path, const std::string& text);

// Creates the folder and proves that a file can be written in it.
void prepare_folder(const std::filesystem::path& folder);

// A line per sphere, `x y z radius [vx vy vz]`; # starts a comment.
Scene read_spheres(const std::filesystem::path& path);

}  // namespace spherepair
