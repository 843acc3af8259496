// SPDX-License-Identifier: MIT
// The subcommands that draw: spherepair render and spherepair frames.
#pragma once

#include "bench/cli/commands.h"
#include "bench/options/options.h"

namespace spherepair {

void add_render(CLI::App& app, CommandLine& line, Action& action);
void add_frames(CLI::App& app, CommandLine& line, Action& action);

}  // namespace spherepair
