// SPDX-License-Identifier: MIT
// The command line of spherepair.
#pragma once

#include "run_action.h"
#include "session.h"

namespace spherepair {

// run_action, or what a test puts in its place to see only what the words are parsed to.
using Runner = int (*)(const std::function<int()>& action);

// Parses the words, of which the first is the program's name, runs the subcommand and returns the exit code
// (commands.h).
int run_program(int argc, const char* const* argv, Opener opener = open_backend, Runner run = run_action);

}  // namespace spherepair
