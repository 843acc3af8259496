// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

namespace spherepair {

// Throws std::invalid_argument for a given option of the parsed subcommand that would have no effect, and for a word
// that is twice in a list. The message says which, why and what to do.
void refuse_unused_options(const CLI::App& command);

}  // namespace spherepair
