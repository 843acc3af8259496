// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace spherepair {

// The given subcommand, or the program itself.
const CLI::App& parsed_command(const CLI::App& app);

// The message after CLI11 refused the words: the word, the fault and the remedy. For an unknown word it suggests the
// nearest name.
std::string complaint_about(const CLI::ParseError& error, const CLI::App& app);

}  // namespace spherepair
