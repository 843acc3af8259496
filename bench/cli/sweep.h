// SPDX-License-Identifier: MIT
// spherepair sweep
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/options/shard.h"

namespace spherepair {

struct SweepCommandOptions {
  std::vector<std::string> backends, methods;  // empty: all
  std::vector<uint64_t> sizes;                 // empty: by machine
  std::vector<double> packing_fractions = {0.3, 0.05};
  std::vector<std::string> orders = {"cold", "warm"};
  uint block = 0;  // 0: as auto chooses it
  int rounds = 11;
  SweepOptions sweep;
};

std::shared_ptr<SweepCommandOptions> add_sweep_options(CLI::App& command);
int sweep_command(const CommandLine& line, const SweepCommandOptions& options);

}  // namespace spherepair
