// SPDX-License-Identifier: MIT
// What an API costs at first: the time to open it, the time of the first search, and memory.
#pragma once

#include <optional>

#include "bench/measure/session.h"

namespace spherepair {

struct FirstUse {
  uint64_t n = 0;                                             // spheres of the search
  double open_s = 0, first_search_s = 0, later_search_s = 0;  // seconds; a search is waited for
  int64_t opened_host = 0, host = 0;                 // bytes in memory of this process, open and with the scene
  std::optional<int64_t> opened_gpu = {}, gpu = {};  // the same on the GPU; none: NVML does not tell
};

// Opens a backend and searches `n` spheres by the grid. Bytes are the growth since before, so other programs must leave
// the GPU alone. The first backend of a process also loads what APIs share.
FirstUse first_use(const std::string& backend, uint64_t n, const OpenOptions& options, const Opener& opener);

json to_json(const FirstUse& use);

}  // namespace spherepair
