// SPDX-License-Identifier: MIT
// A sweep that several machines share out and that can be taken up again: one file a configuration, named by what
// decides its numbers.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/io/report.h"

namespace spherepair {

struct SweepOptions {
  std::string output;         // folder
  std::string shard = "1/1";  // part i of n, counted from 1
  bool resume = false;        // leave out configurations whose record is there
  bool list = false;          // only name them
};

struct SweepTask {
  std::string file;   // within the folder
  std::string title;  // one line for the reader
  // Returns the file's text, or nothing when a wrong answer was found and reported.
  std::function<std::optional<std::string>()> run;
};

// --output, --shard, --resume, --list
void add_shard_options(CLI::App& command, SweepOptions& options);

// 16 hexadecimal digits.
std::string hash_of(const json& what_decides);

// Runs this shard's configurations. `resume` leaves those out whose file is JSON that is_record knows as whole. Returns
// an exit code; throws std::invalid_argument when the shard is not understood or the folder cannot be written.
int run_sweep(const std::vector<SweepTask>& all, const SweepOptions& options, bool (*is_record)(const json&));

}  // namespace spherepair
