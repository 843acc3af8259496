// SPDX-License-Identifier: MIT
// spherepair sets
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"

namespace spherepair {

struct SetsOptions {
  std::vector<std::string> backends, methods, precisions;  // empty: all
  bool quick = false;
  std::string results;  // empty: default_results()
};

std::shared_ptr<SetsOptions> add_sets_options(CLI::App& command);
int sets_command(const CommandLine& line, const SetsOptions& options);

}  // namespace spherepair
