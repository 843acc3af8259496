// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace spherepair {

// Runs a subcommand; its errors, and output that could not be written, become messages on standard error and exit codes
// (commands.h).
int run_action(const std::function<int()>& action);

}  // namespace spherepair
