// SPDX-License-Identifier: MIT
#include "bench/check/finite_state.h"

#include <fmt/format.h>

#include "bench/io/report.h"
#include "common/scene/scene_bounds.h"

namespace spherepair {

void require_finite(const Backend::State& state, uint64_t step) {
  const std::string unsound = unsound_spheres(state.positions, state.velocities);
  if (unsound.empty()) return;
  throw std::invalid_argument(fmt::format(
      "after step {} {}; take a smaller --dt, or spheres that are slower or nearer to the origin", step, unsound));
}

std::string stalled_warning(const Scene& scene) {
  const uint64_t stalled = stalled_spheres(scene);
  if (stalled == 0) return "";
  const std::string who = stalled == 1 ? "1 sphere is" : fmt::format("{} spheres are", stalled);
  return wrapped(fmt::format("WARNING: {} too far from the origin for their speed: a step is less than half an ulp of "
                             "their float32 position, so they do not move. Use --precision compensated or --motion "
                             "anchored.",
                             who),
                 "", "  ") +
         "\n";
}

}  // namespace spherepair
