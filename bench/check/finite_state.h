// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/motion.h"

namespace spherepair {

// Throws std::invalid_argument naming the step and the first sphere whose state is beyond float32. Commands call it for
// every state before it is collided, drawn, saved or compared.
void require_finite(const Motion::State& state, uint64_t step);

// Warns of spheres that do not move because rounding loses their steps, and says what to do; empty without any.
std::string stalled_warning(const Scene& scene);

}  // namespace spherepair
