// SPDX-License-Identifier: MIT
#include <omp.h>

#include <algorithm>

#include "common/backend/growing_list.h"
#include "common/cpu/search/cpu_pairs.h"
#include "common/shared/contact/image_pair.h"
#include "common/shared/swept.h"

namespace spherepair {

namespace {

// Finds the pairs of a list that collides(i, j) is true for.
template <typename Collides>
PairsFound search_near(const SearchInput& search, std::span<const Pair> near, Collides collides) {
  uint64_t pairs = 0;
  std::vector<GrowingList<Pair>> lists(static_cast<size_t>(search.threads));
#pragma omp parallel for num_threads(search.threads) schedule(static) reduction(+ : pairs) if (near.size() > 4096)
  for (const auto& [i, j] : near) {
    if (!collides(i, j)) continue;
    const Pair pair = {std::min(i, j), std::max(i, j)};
    lists[size_t(omp_get_thread_num())].append(&pair, 1);
    ++pairs;
  }
  PairsFound found;
  found.counts.resize(search.positions.size());
  found.list = joined<Pair>(lists, pairs);
  std::ranges::sort(found.list);
  for (const Pair& pair : found.list) ++found.counts[pair.first], ++found.counts[pair.second];
  found.totals.pairs = pairs;
  found.totals.fingerprint = fingerprint(found.list);
  found.totals.colliding_spheres = uint64_t(std::ranges::count_if(found.counts, colliding));
  if (!search.options.want_pairs) found.list.clear();
  return found;
}

}  // namespace

PairsFound search_swept(const SearchInput& search, std::span<const vec4> velocities, std::span<const Pair> near) {
  const std::span<const vec4> at = search.positions;
  const Params& p = search.params;
  return search_near(search, near, [&](uint i, uint j) {
    return touch_within(at[i], velocities[i], at[j], velocities[j], p.motion, p.search.filter_scale,
                        p.search.filter_offset);
  });
}

PairsFound search_images(const SearchInput& search, std::span<const Pair> near) {
  const std::span<const vec4> at = search.positions;
  const Params& p = search.params;
  return search_near(search, near, [&](uint i, uint j) {
    return images_collide(at[i], at[j], p.contact, p.search.filter_scale, p.search.filter_offset);
  });
}

}  // namespace spherepair
