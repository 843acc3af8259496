// SPDX-License-Identifier: MIT
// Finds colliding pairs on the CPU.
#pragma once

#include "common/backend/search.h"

namespace spherepair {

struct SearchInput {
  std::span<const vec4> positions;
  Params params;  // of the scene and the predicate
  bool equal_radii;
  CollideOptions options;
  int threads;
};

struct PairsFound {
  Collisions totals;
  std::vector<uint> counts;  // contacts of each sphere
  std::vector<Pair> list;    // canonical order; filled when options.want_pairs
};

PairsFound search_sequential(const SearchInput& search);  // the paper's code 2: one thread, double loop
PairsFound search_parallel(const SearchInput& search);    // all threads, SIMD, each unordered pair once
PairsFound search_groups(const SearchInput& search);      // within groups of options.block consecutive spheres

// Finds the pairs that touch within the next step (swept.h). near: colliding pairs of the spheres around the paths,
// which begin with these velocities.
PairsFound search_swept(const SearchInput& search, std::span<const vec4> velocities, std::span<const Pair> near);

// Finds the pairs that collide in the scene's periodic box among near pairs, whose order within a pair is any.
PairsFound search_images(const SearchInput& search, std::span<const Pair> near);

}  // namespace spherepair
