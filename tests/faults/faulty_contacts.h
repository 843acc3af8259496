// SPDX-License-Identifier: MIT
// Steps with contacts that go wrong in one known way, and what a resumed run then begins with.
#pragma once

#include "tests/faults/faulty_backend.h"

namespace spherepair {

bool spoils_steps(Fault fault);

// The state behind a step from `before` to `after`. earlier: the state a step ahead of `before`, empty in the first
// step. first_list: the near pairs of the start still serve.
Backend::State spoiled_step(Fault fault, const Scene& scene, const Backend::State& earlier,
                            const Backend::State& before, const Backend::State& after, bool first_list);

// The saved state that the next steps of a resumed run begin with.
MotionState spoiled_start(Fault fault, const Scene& scene, MotionState saved);

}  // namespace spherepair
