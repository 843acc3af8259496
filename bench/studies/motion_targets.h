// SPDX-License-Identifier: MIT
// Performance targets of a motion step on a GPU, and whether they are met.
#pragma once

#include "bench/studies/work_precision.h"

namespace spherepair {

struct Target {
  std::string what;
  double value, bound;
  bool at_least;  // value >= bound, else value <= bound
  bool met() const { return at_least ? value >= bound : value <= bound; }
};

// For GPUs: `paper` in float32 reaches 85 % of the copy bandwidth and takes at most 1.05x as long in GLSL as in CUDA;
// `anchored` in float32 is twice as fast and more accurate where about 1 % of the spheres (0.5 to 2 %) bounce per step.
// Targets that were not measured have no entry.
std::vector<Target> motion_targets(const Session& session, const std::vector<ErrorEntry>& errors,
                                   const std::vector<TimeEntry>& times, const std::vector<CopyEntry>& copies);

Table target_table(const std::vector<Target>& targets);
json to_json(const Target& target);

}  // namespace spherepair
