// SPDX-License-Identifier: MIT
// The timing core of all backends: a fixed number of rounds; in each round every contender takes a turn of batches.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/io/report.h"
#include "bench/measure/contest.h"
#include "bench/measure/session.h"

namespace spherepair {

// Warms up and chooses K: in a contest one for contenders on the host and one for those on devices. In each round the
// contests come in random order, and the contenders of each run right after each other, in random order. Threads on the
// host are pinned. Device timers run last, in a run of their own.
std::vector<Samples> measure(Session& session, std::span<const Contender> contenders, const Sampling& sampling,
                             Progress& progress);

// Predicted seconds of measuring the same contenders when each step takes `growth` times as long.
double predict_seconds(std::span<const Samples> samples, double growth, const Sampling& sampling);

}  // namespace spherepair
