// SPDX-License-Identifier: MIT
// Files that grow with a run.
#pragma once

#include <string>

#include "bench/run/run_options.h"

namespace spherepair {

// What a run leaves of its file of statistics, up to and with this row, its first. A run from a checkpoint keeps the
// rows of the run that it continues, and drops those behind the checkpoint's step, which it computes again. Throws
// std::invalid_argument where the file is of another run, or has rows that this one, up to step `end`, would lose.
std::string first_rows(const RunOptions& options, const Start& start, const std::string& row, uint64_t end);

// A frame of the trajectory: extended XYZ with the step, the time in seconds and the box.
std::string trajectory_frame(const Scene& scene, const Backend::State& state, uint64_t step);

// Throws for a file that is no extended XYZ, and for frames that a run from a checkpoint would replace.
void check_trajectory(const RunOptions& options);

}  // namespace spherepair
