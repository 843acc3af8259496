// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

namespace spherepair {

// Throws std::invalid_argument for an option of the parsed subcommand that was given and would change nothing, and for
// a word that stands twice in a list: which, why, and what to do.
void refuse_unused_options(const CLI::App& command);

}  // namespace spherepair
