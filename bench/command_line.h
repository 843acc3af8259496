// SPDX-License-Identifier: MIT
// The command line of spherepair.
#pragma once

#include "session.h"

namespace spherepair {

// Parses the words, of which the first is the program's name, runs the subcommand and returns the exit code (commands.h).
int run_program(int argc, const char* const* argv, const Opener& opener = open_backend);

}  // namespace spherepair
