// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace spherepair {

// The subcommand that was given, or the program itself.
const CLI::App& parsed_command(const CLI::App& app);

// After CLI11 refused the words: what is wrong with which, and what to do. For a word that nothing takes, the name that
// was perhaps meant.
std::string complaint_about(const CLI::ParseError& error, const CLI::App& app);

}  // namespace spherepair
