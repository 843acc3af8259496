// SPDX-License-Identifier: MIT
// Options shared by several subcommands.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

#include "bench/formats/start.h"
#include "bench/io/motion_choice.h"
#include "bench/io/numbers.h"
#include "common/backend/backend.h"

namespace spherepair {

using Action = std::function<int()>;

// For transform(), which puts the digits in place of 16k or 1e6.
CLI::Validator whole_number(uint64_t low, uint64_t high);
CLI::Validator real_number(double low, double high);

constexpr uint64_t kMostSteps = uint64_t(1) << 53;
const auto count_range = whole_number(0, kMostSpheres);
const auto positive_range = whole_number(1, kMostSpheres);
const auto steps_range = whole_number(0, kMostSteps);
const auto block_range = whole_number(32, 1024);
const auto fraction_range = real_number(1e-15, 0.74);  // as in check_options
const auto sample_range = real_number(1e-6, 60);       // seconds

// Refuses an empty value for every option that takes one: it would be read as no value.
void refuse_empty_values(CLI::App& command);

// --backend: `auto`, the default, leaves the name empty (choose_backend); an unknown one is refused.
void add_backend_option(CLI::App& command, std::string& backend, const std::string& what);
// --backends of a study, each of which must open: none, or `auto`, stands for all that open.
void add_backends_option(CLI::App& command, std::vector<std::string>& backends);

// --results of a study, which writes these files into it.
void add_results_option(CLI::App& command, std::string& results, const std::string& files);

void add_open_options(CLI::App& command, OpenOptions& open);
void add_scene_options(CLI::App& command, SceneOptions& scene);
void add_block_option(CLI::App& command, uint& block);

// --columns, --decimal-comma and --ignore-periodic, of files of spheres.
void add_file_options(CLI::App& command, std::vector<std::string>& columns, bool& decimal_comma, bool& ignore_periodic);

// A scene, a file or a checkpoint, and the motion. Call finish_start_options in the command's callback.
void add_start_options(CLI::App& command, StartOptions& start);
void finish_start_options(const CLI::App& command, StartOptions& start);

// --motion, --precision, --dt and --restitution.
void add_motion_options(CLI::App& command, MotionChoice& motion);

// --contact, --stiffness, --drag, --no-sleeping and --walls, after those of the motion.
void add_contact_options(CLI::App& command, MotionChoice& motion);

// --steps, --until-step, --time and --until-rest: how long a run moves.
void add_length_options(CLI::App& command, std::optional<uint64_t>& steps, std::optional<uint64_t>& until_step,
                        std::optional<double>& seconds, bool& until_rest);

// --save and --save-every.
void add_save_options(CLI::App& command, std::string& file, uint64_t& every);

// --statistics and --statistics-every.
void add_statistics_options(CLI::App& command, std::string& file, uint64_t& every);

// --resume excludes every option of the scene and its motion; add those to the command first.
void add_resume_option(CLI::App& command, std::string& file);

void add_size_option(CLI::App& command, uint& width, uint& height);  // --size 1280x720

}  // namespace spherepair
