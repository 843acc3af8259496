// SPDX-License-Identifier: MIT
// Reads and writes files. Each throws std::invalid_argument naming the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/io/output_files.h"
#include "bench/io/report.h"
#include "common/scene/scene.h"

namespace spherepair {

// Replaces a regular file atomically (ReplacedFile).
void write_file(const std::filesystem::path& path, const std::string& text);

// `-` as an output file: standard output. A report then goes to standard error.
inline constexpr const char* kStandardOutput = "-";
void write_json(const std::string& file, const json& record);       // an empty name: nothing is written
void add_json_output(OutputFiles& files, const std::string& file);  // of --json

// Creates the folder and checks that these files can be written in it. results: --results; empty: a new folder in
// results/.
void prepare_folder(const std::filesystem::path& folder, const std::vector<std::string>& files);
std::filesystem::path prepare_results(const std::string& results, const std::vector<std::string>& files);

// One sphere per line, `x y z radius [vx vy vz]`; # starts a comment. A malformed line is refused with its number.
Scene read_spheres(const std::filesystem::path& path);

}  // namespace spherepair
