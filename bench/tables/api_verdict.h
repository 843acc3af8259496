// SPDX-License-Identifier: MIT
// Sums up in one sentence which API is faster where, from the comparisons of all tables.
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

// The sentence, or the reason why there is none: no GPU, a missing API, nothing timed in both.
std::string api_verdict(const Session& session, const std::vector<ApiContest>& all);

}  // namespace spherepair
