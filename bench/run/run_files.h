// SPDX-License-Identifier: MIT
// Files that grow with a run.
#pragma once

#include <string>

#include "bench/run/run_options.h"

namespace spherepair {

// The first text of the file of statistics, up to `row`, the run's first. A run from a checkpoint keeps the rows up to
// the checkpoint's step and computes later ones again. Throws std::invalid_argument if the file is another run's, or
// has rows after step `end`, at which this run ends.
std::string first_rows(const RunOptions& options, const Start& start, const std::string& row, uint64_t end);

// A frame of the trajectory: extended XYZ with the step, the time in seconds and the box.
std::string trajectory_frame(const Scene& scene, const Motion::State& state, uint64_t step);

// Throws for a file that is not extended XYZ, and for frames that a run from a checkpoint would replace.
void check_trajectory(const RunOptions& options);

}  // namespace spherepair
