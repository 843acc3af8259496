// SPDX-License-Identifier: MIT
// spherepair skips: what is saved by leaving out what a scene does not need, and by what one API alone offers. Each is
// timed on and off, in turns, after both have given the same set.
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "commands.h"

namespace spherepair {

struct SkipsOptions {
  std::vector<std::string> backends, names;  // empty: all that open, all skips and tricks
  std::vector<uint64_t> sizes;               // empty: one that suits the machine
  double packing_fraction = 0.3;
  int rounds = 11;
  std::string json_file = "skips.json";
};

std::shared_ptr<SkipsOptions> add_skips_options(CLI::App& command);
int skips_command(const CommandLine& line, const SkipsOptions& options);

}  // namespace spherepair
