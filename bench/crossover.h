// SPDX-License-Identifier: MIT
// spherepair crossover: where the grid overtakes all pairs, and whether Method::automatic takes the faster one.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "commands.h"

namespace spherepair {

struct CrossoverOptions {
  std::vector<std::string> backends;  // empty: all that open
  std::vector<uint64_t> sizes;        // empty: 64 to 2^15
  std::vector<std::string> kinds;     // of spheres, see sphere_kinds(); empty: all
  int rounds = 11;
  double most_ms = 50;  // of a step: slower contenders are not tried at more spheres
  std::string json_file = "crossover.json";
};

std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command);
int crossover_command(const CommandLine& line, const CrossoverOptions& options);

}  // namespace spherepair
