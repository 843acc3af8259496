// SPDX-License-Identifier: MIT
// What `spherepair run` is asked for.
#pragma once

#include <optional>

#include "bench/formats/start.h"
#include "bench/options/command.h"

namespace spherepair {

struct RunOptions {
  std::string backend, method;  // no backend: the fastest that opens; no method: auto
  StartOptions start;
  uint block = 0;                             // 0: not given
  std::optional<uint64_t> steps, until_step;  // at most one of these and of seconds; none: 0 steps
  std::optional<double> seconds;
  bool until_rest = false;  // where all of these are the most
  Verbosity verbosity = Verbosity::normal;
  bool per_step = false, naive = false, swept = false, hashes = false;
  std::string pairs_file, contacts_file, json_file;
  std::string spheres_file;         // those at the end
  std::string save_file;            // a checkpoint
  uint64_t save_every = 0;          // steps; 0: only at the end
  std::string statistics_file;      // of contacts, .csv
  uint64_t statistics_every = 1;    // steps
  std::string trajectory_file;      // .extxyz
  uint64_t trajectory_every = 100;  // steps
};

// The step that the run ends with at the latest. Throws std::invalid_argument where that is before the start.
uint64_t end_of(const RunOptions& options, const Start& start);

// The command that goes on from the checkpoint of this step to the step `end`, for a shell. Its frames go into another
// file: trajectory-5000.extxyz.
std::string command_to_go_on(const RunOptions& options, uint64_t step, uint64_t end);

}  // namespace spherepair
