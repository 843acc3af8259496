// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace spherepair {

// Runs a subcommand. Exceptions and failed writes to standard output become messages on standard error and exit codes
// (commands.h).
int run_action(const std::function<int()>& action);

}  // namespace spherepair
