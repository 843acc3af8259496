// SPDX-License-Identifier: MIT
// Options shared by several subcommands.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

#include "bench/formats/start.h"
#include "bench/io/motion_choice.h"
#include "bench/io/numbers.h"
#include "bench/options/command.h"
#include "common/backend/backend.h"

namespace spherepair {

// For transform(), which replaces 16k or 1e6 by digits.
CLI::Validator whole_number(uint64_t low, uint64_t high);
CLI::Validator real_number(double low, double high);

constexpr uint64_t kMostSteps = uint64_t(1) << 53;
const auto count_range = whole_number(0, kMostSpheres);
const auto positive_range = whole_number(1, kMostSpheres);
const auto steps_range = whole_number(0, kMostSteps);
const auto block_range = whole_number(32, 1024);
const auto fraction_range = real_number(1e-15, 0.74);  // as in check_options

// Options of one number in a range, or of numbers or names separated by commas. Their current value is the default in
// --help.
template <typename T>
CLI::Option* add_number(CLI::App& command, const char* name, T& value, const CLI::Validator& range, const char* text) {
  return command.add_option(name, value, text)->transform(range)->capture_default_str();
}
template <typename T>
CLI::Option* add_list(CLI::App& command, const char* name, std::vector<T>& values, const std::string& text) {
  CLI::Option* option = command.add_option(name, values, text)->delimiter(',');
  return values.empty() ? option : option->capture_default_str();
}

// Refuses an empty value for every option that takes one: it would be read as no value.
void refuse_empty_values(CLI::App& command);

// --backend: `auto`, the default, leaves the name empty (choose_backend); an unknown one is refused.
void add_backend_option(CLI::App& command, std::string& backend, const std::string& what);
// --backends of a study: each named one must open; without names, or with `auto`, all that open.
void add_backends_option(CLI::App& command, std::vector<std::string>& backends);

// --rounds and --min-seconds of timings; --results: the folder into which a study writes `files`.
void add_rounds_option(CLI::App& command, int& rounds, uint64_t least = 1);
void add_min_seconds_option(CLI::App& command, double& seconds);
void add_results_option(CLI::App& command, std::string& results, const std::string& files);

void add_open_options(CLI::App& command, OpenOptions& open);
void add_block_option(CLI::App& command, uint& block);

// --columns, --decimal-comma and --ignore-periodic, of files of spheres.
void add_file_options(CLI::App& command, std::vector<std::string>& columns, bool& decimal_comma, bool& ignore_periodic);

// The options for a scene, a file or a checkpoint, and for the motion.
void add_start_options(CLI::App& command, StartOptions& start);

void add_motion_options(CLI::App& command, MotionChoice& motion);
void add_contact_options(CLI::App& command, MotionChoice& motion);  // call it after add_motion_options

void add_verbosity_options(CLI::App& command, Verbosity& verbosity);
void add_size_option(CLI::App& command, uint& width, uint& height);  // --size 1280x720

}  // namespace spherepair
