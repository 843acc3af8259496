// SPDX-License-Identifier: MIT
// spherepair crossover: from how many spheres on the grid is faster than all pairs, and whether Method::automatic
// chooses the faster one.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/studies/crossover_sweep.h"

namespace spherepair {

std::shared_ptr<CrossoverOptions> add_crossover_options(CLI::App& command);
int crossover_command(const CommandLine& line, const CrossoverOptions& options);

}  // namespace spherepair
