// SPDX-License-Identifier: MIT
// spherepair precision
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"

namespace spherepair {

struct PrecisionOptions {
  std::vector<std::string> backends, methods, precisions;  // empty: all
  std::vector<int> steps;                                  // k of dt = 2^-k; empty: by machine
  uint64_t n = 0;                                          // of the timings; 0: by machine
  int rounds = 11;
  bool quick = false;
  std::string results;  // empty: default_results()
};

std::shared_ptr<PrecisionOptions> add_precision_options(CLI::App& command);
int precision_command(const CommandLine& line, const PrecisionOptions& options);

}  // namespace spherepair
