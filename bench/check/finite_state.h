// SPDX-License-Identifier: MIT
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Throws std::invalid_argument that names the step and the first sphere whose numbers left float32 by then. To be
// called of every state that a command looks at, before it is collided, drawn, saved or compared.
void require_finite(const Backend::State& state, uint64_t step);

}  // namespace spherepair
