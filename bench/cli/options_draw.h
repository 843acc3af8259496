// SPDX-License-Identifier: MIT
// The subcommands that draw: spherepair render and spherepair frames.
#pragma once

#include "bench/cli/commands.h"
#include "bench/options/options.h"

namespace spherepair {

void add_render(CLI::App& app, CommandLine& line, Action& action);

// Throw std::invalid_argument. images: of which each becomes a file.
void check_render_options(const RenderOptions& options);
void check_render_files(const RenderOptions& options, uint64_t images);

void add_frames(CLI::App& app, CommandLine& line, Action& action);

}  // namespace spherepair
