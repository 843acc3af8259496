// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace spherepair {

// The subcommand that was given, or the program itself.
const CLI::App& parsed_command(const CLI::App& app);

// After CLI11 refused the words: the first that nothing takes, with the name that was perhaps meant; empty if something
// else is wrong.
std::string unknown_word(const CLI::App& app);

}  // namespace spherepair
