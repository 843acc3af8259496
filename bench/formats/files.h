// SPDX-License-Identifier: MIT
// Writes files. All throw std::invalid_argument naming the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/io/output_files.h"
#include "bench/io/report.h"

namespace spherepair {

// Replaces a regular file atomically (ReplacedFile).
void write_file(const std::filesystem::path& path, const std::string& text);

// The same, but `-` writes to standard output, and an empty name writes nothing.
void write_text(const std::string& file, const std::string& text);
void write_json(const std::string& file, const json& record);

// Creates the folder and checks that these files can be written in it. results: --results; empty: a new folder in
// results/.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& files);
std::filesystem::path prepare_results(const std::string& results, const std::vector<std::string>& files);

}  // namespace spherepair
