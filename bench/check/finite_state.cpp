// SPDX-License-Identifier: MIT
#include "bench/check/finite_state.h"

#include <fmt/format.h>

#include "bench/io/report.h"

namespace spherepair {

void require_finite(const Motion::State& state, uint64_t step) {
  const std::string unsound = unsound_spheres(state.positions, state.velocities);
  if (unsound.empty()) return;
  throw std::invalid_argument(fmt::format(
      "after step {} {}; take a smaller --dt, or spheres that are slower or nearer to the origin", step, unsound));
}

std::string stalled_warning(const Scene& scene) {
  const uint64_t stalled = stalled_spheres(scene);
  if (stalled == 0) return "";
  return wrapped(
             fmt::format("WARNING: {} too far from the origin to move: at this speed a step is less than half an ulp "
                         "of a float32 position. A run started with --precision compensated or --motion anchored "
                         "does not lose it.",
                         stalled == 1 ? "1 sphere is" : fmt::format("{} spheres are", stalled)),
             "", "  ") +
         "\n";
}

}  // namespace spherepair
