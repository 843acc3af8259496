// SPDX-License-Identifier: MIT
#include "tests/oracle/tally.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/backend/backend.h"
#include "tests/oracle/oracle.h"

namespace spherepair {
namespace {

constexpr uint64_t total_planned() {
  uint64_t total = 0;
  for (const FamilyPairs& plan : PLANS) total += plan.pairs;
  return total;
}
static_assert(total_planned() >= 10'000'000 && PLANS[size_t(Family::quadruple)].pairs * 10 >= total_planned());

void count_pair(Tally& tally, Relation truth, uint verdict, const vec4* pair) {
  ++tally.pairs;
  tally.ties += truth == Relation::tangent;
  tally.overlapping += truth == Relation::overlapping;
  tally.nonfinite += truth == Relation::nonfinite;
  const uint stage = verdict / 2;
  const bool possible = stage < STAGES && (stage != STAGE_NONFINITE || truth == Relation::nonfinite);
  if (possible) ++tally.by_stage[stage];
  if (possible && (verdict % 2 == 1) == (truth == Relation::overlapping)) return;
  if (tally.wrong++ == 0)
    tally.first_wrong = fmt::format("{}: verdict {}, relation {}", show_pair(pair[0], pair[1]), verdict, int(truth));
}

}  // namespace

Tally tally(Family family, uint64_t pairs, const Decider& decide) {
  constexpr uint64_t batch = 1 << 18;
  Tally result;
  for (uint64_t first = 0; first < pairs; first += batch) {
    const std::vector<vec4> spheres = adversarial_pairs(family, first, std::min(batch, pairs - first));
    const std::vector<Relation> truths = relations(spheres);
    const std::vector<uint> verdicts = decide(spheres);
    if (verdicts.size() != truths.size())
      throw BackendError(fmt::format("{} verdicts for {} pairs", verdicts.size(), truths.size()));
    for (size_t k = 0; k < truths.size(); ++k) count_pair(result, truths[k], verdicts[k], &spheres[2 * k]);
  }
  return result;
}

std::vector<uint> decide_directly(std::span<const vec4> spheres) {
  std::vector<uint> verdicts(spheres.size() / 2);
  const float scale = bits_float(FILTER_SCALE_BITS), offset = bits_float(FILTER_OFFSET_BITS);
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < verdicts.size(); ++k)
    verdicts[k] = verdict_code(decide_pair(spheres[2 * k], spheres[2 * k + 1], scale, offset));
  return verdicts;
}

Decider decider_of(bool (*collide)(vec4 a, vec4 b)) {
  return [collide](std::span<const vec4> spheres) {
    std::vector<uint> verdicts(spheres.size() / 2);
    for (size_t k = 0; k < verdicts.size(); ++k) verdicts[k] = collide(spheres[2 * k], spheres[2 * k + 1]) ? 1 : 0;
    return verdicts;
  };
}

std::string show_pair(const vec4& a, const vec4& b) {
  return fmt::format("({:a}, {:a}, {:a}; {:a}) ({:a}, {:a}, {:a}; {:a})", a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
}

}  // namespace spherepair
