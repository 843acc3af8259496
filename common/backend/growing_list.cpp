// SPDX-License-Identifier: MIT
#include "common/backend/growing_list.h"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "common/backend/scene_holder.h"

namespace spherepair {

// Small requests skip the question.
bool fits_in_memory(uint64_t bytes) {
  constexpr uint64_t small = 64 << 20;
  if (bytes <= small) return true;
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    uint64_t kibibytes = 0;
    if (word == "MemAvailable:" && file >> kibibytes) return bytes <= kibibytes * 1024;
  }
  return true;
}

void fail_for_list(uint64_t pairs) {
  constexpr double bytes_per_pair = 24;  // a pair as threads find it, split by sphere, and in order
  throw BackendError(
      fmt::format("cpu: {} pairs collide, and a list of them takes about {:.1f} GB, more than is free; ask for the "
                  "numbers without the list, or for fewer spheres",
                  pairs, double(pairs) * bytes_per_pair / 1e9));
}

}  // namespace spherepair
