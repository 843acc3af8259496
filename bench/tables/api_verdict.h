// SPDX-License-Identifier: MIT
// Sums up where OpenGL and Vulkan are faster or slower than CUDA, from the comparisons of all tables.
#pragma once

#include <string>
#include <vector>

#include "bench/measure/session.h"
#include "bench/measure/timing.h"

namespace spherepair {

struct ApiContest {
  std::string table;
  Contest contest;  // a device's time against the baseline's
};

// Sums up contests of one API with CUDA: the ratios of its time where they differ, and how many do not.
std::string summary_of(const std::string& title, const std::vector<ApiContest>& contests);

// A sentence for OpenGL and one for Vulkan. Each says instead why it cannot tell if there was no GPU, an API is
// missing, or nothing was timed in both.
std::vector<std::string> api_verdicts(const Session& session, const std::vector<ApiContest>& all);

}  // namespace spherepair
