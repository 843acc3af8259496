// SPDX-License-Identifier: MIT
#include <omp.h>

#include <algorithm>

#include "cpu_pairs.h"
#include "hash.h"
#include "swept.h"

namespace spherepair {

PairsFound search_swept(const PairSearch& search, std::span<const vec4> velocities) {
  const std::span<const vec4> at = search.positions;
  const Params& p = search.params;
  const uint n = uint(at.size());
  PairsFound found;
  found.counts.resize(n);
#pragma omp parallel for num_threads(search.threads) schedule(dynamic, 16) if (n > 256)
  for (uint i = 0; i < n; ++i) {
    std::vector<uint> others;
    for (uint j = i + 1; j < n; ++j) {
      if (!in_swept_reach(at[i], velocities[i], at[j], velocities[j], p.dt)) continue;
      if (touch_within(at[i], velocities[i], at[j], velocities[j], p.dt, p.filter_scale, p.filter_offset))
        others.push_back(j);
    }
    if (others.empty()) continue;
#pragma omp critical
    for (uint j : others) {
      found.list.push_back({i, j});
      ++found.counts[i];
      ++found.counts[j];
    }
  }
  std::ranges::sort(found.list);
  found.totals.pairs = found.list.size();
  found.totals.fingerprint = fingerprint(found.list);
  found.totals.colliding_spheres = uint64_t(std::ranges::count_if(found.counts, colliding));
  if (!search.options.want_pairs) found.list.clear();
  return found;
}

}  // namespace spherepair
