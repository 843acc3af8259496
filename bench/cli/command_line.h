// SPDX-License-Identifier: MIT
// The command line of spherepair.
#pragma once

#include "api/open.h"
#include "bench/measure/session.h"
#include "bench/options/run_action.h"

namespace spherepair {

// Runs a subcommand whose arguments were parsed; a test can replace it.
using Runner = int (*)(const std::function<int()>& action);
inline int run_directly(const std::function<int()>& action) { return action(); }

// Parses the arguments, runs the subcommand and returns the exit code (commands.h).
int run_program(int argc, const char* const* argv, const Opener& opener = open_backend, Runner run = run_directly,
                const Clocks& clocks = host_clocks());

}  // namespace spherepair
