// SPDX-License-Identifier: MIT
// Files that grow with a run.
#pragma once

#include <string>

#include "bench/run/run_options.h"

namespace spherepair {

// The text that the file of statistics begins with, up to this row, the run's first. A run from a checkpoint keeps the
// rows up to the checkpoint's step; it computes the later ones again. Throws std::invalid_argument where the file is of
// another run, or has rows behind step `end`, where this run ends.
std::string first_rows(const RunOptions& options, const Start& start, const std::string& row, uint64_t end);

// A frame of the trajectory: extended XYZ with the step, the time in seconds and the box.
std::string trajectory_frame(const Scene& scene, const Backend::State& state, uint64_t step);

// Throws for a file that is no extended XYZ, and for frames that a run from a checkpoint would replace.
void check_trajectory(const RunOptions& options);

}  // namespace spherepair
