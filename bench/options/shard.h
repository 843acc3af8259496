// SPDX-License-Identifier: MIT
// A sweep that several machines can share and that can be resumed: one file per configuration, named by a hash of
// everything that determines its results.
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
  std::string results;        // folder; empty: a new one
  std::string shard = "1/1";  // part i of n, counted from 1
  bool resume = false;        // skip configurations whose record exists
  bool list = false;          // only list them
};

struct SweepTask {
  std::string file;   // within the folder
  std::string title;  // one line for the reader
  // Returns the file's text, or nothing when a wrong result was found and reported.
  std::function<std::optional<std::string>()> run;
};

// --results, --shard, --resume, --list
void add_shard_options(CLI::App& command, SweepOptions& options);

// 16 hexadecimal digits.
std::string hash_of(const json& key);

// Runs this shard's configurations; with `resume`, skips those whose file is_record accepts as complete. Returns an
// exit code; throws std::invalid_argument for a malformed shard or a folder that cannot be written.
int run_sweep(const std::vector<SweepTask>& all, const SweepOptions& options, bool (*is_record)(const json&));

}  // namespace spherepair
