// SPDX-License-Identifier: MIT
// The options of the subcommand pairs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/options/verbosity.h"
#include "common/shared/layout.h"

namespace spherepair {

struct PairsOptions {
  std::string backend, method;                     // no backend: the fastest that opens; no method: auto
  std::string input_file, output_file, json_file;  // no output: only the summary
  std::string contacts_file;                       // the number of contacts of each sphere
  bool geometry = false;                           // overlap, normal and point of each pair as well
  bool distances = false;                          // of the centres of each pair as well
  bool csr = false;                                // a full neighbour list in place of the pairs
  std::optional<double> radius;
  std::optional<double> cutoff = {};  // of points: the distance up to which they are a pair
  std::optional<uint64_t> frame;
  std::vector<std::string> columns;
  bool decimal_comma = false;
  bool ignore_periodic = false;
  uint block = 0;  // 0: not given
  Verbosity verbosity = Verbosity::normal;
};

// All but those for opening backends.
void add_pairs_options(CLI::App& command, PairsOptions& options);

}  // namespace spherepair
