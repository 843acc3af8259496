// SPDX-License-Identifier: MIT
// Spoils steps with contacts, or the start of a resumed run, in one known way.
#pragma once

#include "tests/faults/faulty_backend.h"

namespace spherepair {

bool spoils_steps(Fault fault);

// The spoiled state after a step from `before` to `after`. earlier: the state one step before `before`, empty in the
// first step. first_list: the list of near pairs made at the start is still in use.
Motion::State spoiled_step(Fault fault, const Scene& scene, const Motion::State& earlier, const Motion::State& before,
                           const Motion::State& after, bool first_list);

// The spoiled state with which a resumed run begins.
MotionState spoiled_start(Fault fault, const Scene& scene, MotionState saved);

}  // namespace spherepair
