// SPDX-License-Identifier: MIT
// The command line of spherepair.
#pragma once

#include "api/open.h"
#include "bench/cli/run_action.h"
#include "bench/measure/session.h"

namespace spherepair {

// Runs a subcommand whose words were understood, or what a test puts in its place.
using Runner = int (*)(const std::function<int()>& action);
inline int run_it(const std::function<int()>& action) { return action(); }

// Parses the words, of which the first is the program's name, runs the subcommand and returns the exit code
// (commands.h).
int run_program(int argc, const char* const* argv, const Opener& opener = open_backend, Runner run = run_it);

}  // namespace spherepair
