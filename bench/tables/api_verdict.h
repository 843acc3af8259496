// SPDX-License-Identifier: MIT
// Which API is faster where: the comparisons of all tables, in one sentence.
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

// Or why it cannot be said: no GPU, an API that is missing, nothing timed in both.
std::string api_verdict(const Session& session, const std::vector<ApiContest>& all);

}  // namespace spherepair
