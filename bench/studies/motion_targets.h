// SPDX-License-Identifier: MIT
// What the study asks of a step of motion on a GPU, and whether it is met.
#pragma once

#include "bench/studies/work_precision.h"

namespace spherepair {

struct Target {
  std::string what;
  double value, bound;
  bool at_least;  // the value must be the bound or more, else the bound or less
  bool met() const { return at_least ? value >= bound : value <= bound; }
};

// Of the GPUs among the backends: `paper` in float32 at 85 % of the bandwidth of copying, GLSL within 5 % of CUDA;
// `anchored` in float32 twice as fast and more accurate where about 1 % of the spheres (0.5 to 2 %) bounce in a step.
// Whatever was not measured has no entry.
std::vector<Target> motion_targets(const Session& session, const std::vector<ErrorEntry>& errors,
                                   const std::vector<TimeEntry>& times, const std::vector<CopyEntry>& copies);

Table target_table(const std::vector<Target>& targets);
json to_json(const Target& target);

}  // namespace spherepair
