// SPDX-License-Identifier: MIT
#include "bench/check/finite_state.h"

#include <fmt/format.h>

#include "common/scene/scene_bounds.h"

namespace spherepair {

void require_finite(const Backend::State& state, uint64_t step) {
  const std::string unsound = unsound_spheres(state.positions, state.velocities);
  if (unsound.empty()) return;
  throw std::invalid_argument(fmt::format(
      "after step {} {}; take a smaller --dt, or spheres that are slower or nearer to the origin", step, unsound));
}

}  // namespace spherepair
