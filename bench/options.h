// SPDX-License-Identifier: MIT
// Options that several subcommands share, and the subcommands that draw.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>

#include "commands.h"

namespace spherepair {

using Action = std::function<int()>;

CLI::Validator whole_number(int64_t low, int64_t high);

constexpr int64_t kMostSpheres = std::numeric_limits<int32_t>::max();
const auto count_range = whole_number(0, kMostSpheres);
const auto positive_range = whole_number(1, kMostSpheres);
const auto steps_range = whole_number(0, int64_t(1) << 53);

void add_open_options(CLI::App& command, OpenOptions& open);
void add_scene_options(CLI::App& command, SceneOptions& scene);

// A scene, a file or a checkpoint, and the motion. The second goes into the command's callback.
void add_start_options(CLI::App& command, StartOptions& start);
void finish_start_options(const CLI::App& command, StartOptions& start);

void add_size_option(CLI::App& command, uint& width, uint& height);  // --size 1280x720

void add_render(CLI::App& app, CommandLine& line, Action& action);
void add_frames(CLI::App& app, CommandLine& line, Action& action);

}  // namespace spherepair
