// SPDX-License-Identifier: MIT
// All backends step one scene together; after every step their states and collision sets are compared.
#pragma once

#include "bench/check/equality.h"
#include "bench/check/step_result.h"

namespace spherepair {

struct LockstepPlan {
  SceneOptions scene;
  uint64_t steps = 10;
  uint64_t every = 1;  // steps between comparisons
  std::vector<Method> methods;
  std::vector<uint> blocks;
  uint64_t largest_list = 1'000'000;  // pairs; larger sets are compared by counts, totals and fingerprint
};

// What agreed, one entry for each set. Throws DifferenceFound at the first difference, std::invalid_argument where
// nothing of an open backend would be compared, std::logic_error where fewer comparisons were made than planned.
std::vector<EqualityEntry> check_lockstep(Session& session, const LockstepPlan& plan, Progress& progress);

// Everyone who runs these methods, at these group sizes where a method has one. On the CPU the devices' arrangements of
// all pairs are left out: they are the search of `parallel`.
std::vector<Configuration> all_configurations(Session& session, const std::vector<Method>& methods,
                                              const std::vector<uint>& blocks);

}  // namespace spherepair
