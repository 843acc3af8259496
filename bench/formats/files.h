// SPDX-License-Identifier: MIT
// Writes files. Both throw std::invalid_argument naming the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace spherepair {

// Replaces a regular file atomically (ReplacedFile).
void write_file(const std::filesystem::path& path, const std::string& text);

// Creates the folder and checks that these files can be written in it.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& files);

}  // namespace spherepair
