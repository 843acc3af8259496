// SPDX-License-Identifier: MIT
// The options of `spherepair run`.
#pragma once

#include "bench/cli/commands.h"
#include "bench/options/options.h"

namespace spherepair {

void add_run(CLI::App& app, CommandLine& line, Action& action);

}  // namespace spherepair
