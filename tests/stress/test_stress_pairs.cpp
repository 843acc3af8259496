// SPDX-License-Identifier: MIT
// Rows 1 to 8 of the stress catalogue: single pairs through every backend's own predicate code.
#include <fmt/format.h>

#include "tests/oracle/tally.h"
#include "tests/support/backends.h"
#include "tests/support/catalogue.h"

namespace spherepair {
namespace {

// In short form a tenth of the plan, but of numbers that are not finite every case.
Tally judge(Backend& backend, Family family) {
  const bool all = is_gpu(backend) || full_stress() || family == Family::nonfinite;
  const Tally result = tally(family, PLANS[size_t(family)].pairs / (all ? 1 : 10),
                             [&](std::span<const vec4> spheres) { return backend.decide(spheres); });
  backend.check_guards();
  EXPECT_EQ(result.wrong, 0u) << "of " << result.pairs << "; the first: " << result.first_wrong;
  fmt::print(
      "{}: {} pairs, {} ties, {} overlapping; by stage {} float, {} double, {} integer, {} wide, {} not finite\n",
      backend.info().name, result.pairs, result.ties, result.overlapping, result.by_stage[STAGE_FLOAT],
      result.by_stage[STAGE_DOUBLE], result.by_stage[STAGE_INTEGER], result.by_stage[STAGE_WIDE],
      result.by_stage[STAGE_NONFINITE]);
  note_figure(fmt::format("{} wrong of {}, {} ties", result.wrong, result.pairs, result.ties));
  return result;
}

TEST_P(StressCatalogue, Row01_RandomBits) {
  const Tally result = judge(backend(), Family::random_bits);
  EXPECT_GT(result.overlapping, result.pairs / 20);
}

TEST_P(StressCatalogue, Row02_NearTangent) {
  const Tally result = judge(backend(), Family::near_tangent);
  EXPECT_GT(result.overlapping, result.pairs / 4);
  EXPECT_GT(result.by_stage[STAGE_DOUBLE], result.pairs / 5);
}

TEST_P(StressCatalogue, Row03_PythagoreanQuadruples) {
  const Tally result = judge(backend(), Family::quadruple);
  EXPECT_EQ(result.ties, result.pairs);
}

TEST_P(StressCatalogue, Row04_QuadruplesOneUlpOff) {
  const Tally result = judge(backend(), Family::quadruple_off);
  EXPECT_GT(result.overlapping, result.pairs / 4);
  EXPECT_LT(result.ties, result.pairs / 4);
}

TEST_P(StressCatalogue, Row05_Denormal) {
  const Tally result = judge(backend(), Family::denormal);
  EXPECT_GT(result.ties, result.pairs / 5);
  EXPECT_GT(result.overlapping, result.pairs / 10);
}

TEST_P(StressCatalogue, Row06_ExtremeExponents) {
  const Tally result = judge(backend(), Family::extreme);
  EXPECT_GT(result.ties, result.pairs / 10);
  EXPECT_GT(result.overlapping, result.pairs / 10);
}

TEST_P(StressCatalogue, Row07_AxisTangencyTinyOffset) {
  const Tally result = judge(backend(), Family::axis_offset);
  EXPECT_GE(result.by_stage[STAGE_WIDE], result.pairs / 4);
  EXPECT_GT(result.ties, result.pairs / 5);
}

TEST_P(StressCatalogue, Row08_NotFiniteExhaustive) {
  const Tally result = judge(backend(), Family::nonfinite);
  EXPECT_EQ(result.nonfinite, result.pairs - 2) << "every case but the two finite ones";
  EXPECT_EQ(result.overlapping, 1u);
}

INSTANTIATE_BACKENDS(StressCatalogue);

class PredicateOf : public BackendTest {};

TEST_P(PredicateOf, LeavesToIntegersWhatFloat64RoundsPastTheSumOfRadii) {
  const Tally result =
      tally(Family::beyond_double, 200'000, [&](std::span<const vec4> spheres) { return backend().decide(spheres); });
  EXPECT_EQ(result.wrong, 0u) << "of " << result.pairs << "; the first: " << result.first_wrong;
  EXPECT_EQ(result.by_stage[STAGE_INTEGER] + result.by_stage[STAGE_WIDE], result.pairs);
  EXPECT_GT(result.overlapping, result.pairs / 3);
}

INSTANTIATE_BACKENDS(PredicateOf);

}  // namespace
}  // namespace spherepair
