// SPDX-License-Identifier: MIT
#include "number_order.h"

#include <algorithm>

#include "cell.h"

namespace spherepair {
namespace {

constexpr uint64_t most_samples = 4096;
constexpr uint nearby = 256;  // one part in so many of all cells

}  // namespace

bool numbers_follow_cells(const std::vector<vec4>& spheres, const GridPlan& plan) {
  if (plan.cells != Cells::dense || spheres.size() < 2) return false;
  Params params{};
  set_grid(params, plan);
  const uint64_t steps = std::min<uint64_t>(most_samples, spheres.size() - 1);
  uint64_t side_by_side = 0;
  for (uint64_t k = 0; k < steps; ++k) {
    const uint64_t i = k * (spheres.size() - 1) / steps;
    const uint a = slot_of(spheres[i], params), b = slot_of(spheres[i + 1], params);
    side_by_side += std::max(a, b) - std::min(a, b) <= plan.slots / nearby;
  }
  return side_by_side >= steps - steps / 4;
}

}  // namespace spherepair
