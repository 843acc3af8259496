// SPDX-License-Identifier: MIT
// The options of `spherepair run`.
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
  bool until_rest = false;  // then the others are an upper limit
  Verbosity verbosity = Verbosity::normal;
  bool per_step = false, naive = false, swept = false, hashes = false;
  std::string pairs_file, contacts_file, json_file;
  std::string spheres_file;         // the spheres at the end
  std::string save_file;            // a checkpoint
  uint64_t save_every = 0;          // steps; 0: only at the end
  std::string statistics_file;      // of contacts, .csv
  uint64_t statistics_every = 1;    // steps
  std::string trajectory_file;      // .extxyz
  uint64_t trajectory_every = 100;  // steps
};

// The last step of the run, if it does not end earlier. Throws std::invalid_argument if that is before the start.
uint64_t end_of(const RunOptions& options, const Start& start);

// The shell command that continues from the checkpoint of this step to the step `end`. It names a new file for frames:
// trajectory-5000.extxyz.
std::string command_to_go_on(const RunOptions& options, uint64_t step, uint64_t end);

}  // namespace spherepair
