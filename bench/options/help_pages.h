// SPDX-License-Identifier: MIT
// Makes pages for shells and man from the descriptions of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace spherepair {

// A script for bash that completes subcommands, options and file names.
std::string bash_completion(const CLI::App& app);

// The manual page spherepair(1), with every subcommand and option.
std::string man_page(const CLI::App& app);

}  // namespace spherepair
