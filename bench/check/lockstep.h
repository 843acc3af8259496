// SPDX-License-Identifier: MIT
// Moves one scene in lockstep on all backends, and compares their states and sets of pairs.
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

// Every backend with each of these methods, at each of these group sizes if the method uses one. The CPU leaves out the
// devices' arrangements of all pairs, which would run `parallel` there.
std::vector<Configuration> all_configurations(Session& session, const std::vector<Method>& methods,
                                              const std::vector<uint>& blocks);

}  // namespace spherepair
