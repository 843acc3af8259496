// SPDX-License-Identifier: MIT
// All backends move one scene in lockstep; their states and collision sets are compared after every step.
#pragma once

#include "bench/check/equality.h"
#include "bench/check/step_result.h"
#include "common/scene/contact_scene.h"

namespace spherepair {

struct LockstepPlan {
  SceneOptions scene;
  uint64_t steps = 10;
  uint64_t every = 1;  // steps between comparisons
  std::vector<Method> methods;
  std::vector<uint> blocks;
  ContactChoice contact = {};
  uint64_t largest_list = 1'000'000;  // pairs; larger sets are compared by counts, totals and fingerprint only
};

// Returns one entry per set. Throws DifferenceFound at the first difference, std::invalid_argument if nothing of an
// open backend would be compared, std::logic_error if fewer comparisons were made than planned.
std::vector<EqualityEntry> check_lockstep(Session& session, const LockstepPlan& plan, Progress& progress);

// Every backend with each of these methods, at each of these group sizes if the method uses one. On the CPU without the
// devices' arrangements of all pairs, which run the search of `parallel` there.
std::vector<Configuration> all_configurations(Session& session, const std::vector<Method>& methods,
                                              const std::vector<uint>& blocks);

}  // namespace spherepair
