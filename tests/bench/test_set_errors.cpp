// SPDX-License-Identifier: MIT
// What `spherepair sets` and the targets of `spherepair precision` say, against sets and numbers found in other ways.
#include <fmt/format.h>

#include <cmath>

#include "bench/studies/set_errors.h"
#include "tests/oracle/oracle.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

const SetPlan small_plan = {.seconds = 2, .n = 700};

TEST(SetErrors, ExactSetsAreThoseOfTheOracleWhereFloatsHoldThem) {
  const Scene scene = drifting_scene(small_plan, {}, 4, 0);
  const std::vector<Pair> wanted = brute_force_pairs(scene.positions);
  EXPECT_GT(wanted.size(), 50u);
  EXPECT_EQ(closed_form_pairs(scene, 0), wanted);
  EXPECT_EQ(state_pairs(scene, {scene.positions, scene.velocities, {}}), wanted);
  EXPECT_EQ(stored_pairs(scene, 0, Precision::float32), wanted);
  std::vector<vec4> far = scene.positions;
  for (vec4& at : far) at = {at.x + 1e5f, at.y + 1e5f, at.z + 1e5f, at.w};
  EXPECT_EQ(stored_pairs(scene, 1e5, Precision::float32), brute_force_pairs(far));
}

// Free fall without a plane, one step that is exact in float32: the closed form's set is that of the floats.
TEST(SetErrors, ClosedFormMovesTheSpheres) {
  Scene scene = drifting_scene(small_plan, {}, 0, 0);
  scene.gravity = 0;
  scene.plane = -1000;
  for (vec4& v : scene.velocities) v = {std::round(4 * v.x), std::round(v.y), std::round(4 * v.z), 0};
  for (vec4& at : scene.positions) at = {std::round(at.x * 64) / 64, std::round(at.y * 64) / 64, at.z, at.w};
  for (vec4& at : scene.positions) at.z = std::round(at.z * 64) / 64;
  std::vector<vec4> moved = scene.positions;
  for (size_t i = 0; i < moved.size(); ++i) {
    const vec4& v = scene.velocities[i];
    moved[i] = {moved[i].x + 3 * v.x, moved[i].y + 3 * v.y, moved[i].z + 3 * v.z, moved[i].w};
  }
  EXPECT_EQ(closed_form_pairs(scene, 3), brute_force_pairs(moved));
  EXPECT_NE(closed_form_pairs(scene, 3), closed_form_pairs(scene, 0));
}

TEST(SetErrors, MissedAndExtraAreCounted) {
  const std::vector<Pair> right = {{0, 1}, {0, 2}, {3, 4}}, found = {{0, 2}, {1, 2}, {1, 5}, {3, 4}};
  EXPECT_EQ(set_error(found, right), (SetError{3, 1, 2}));
  EXPECT_EQ(set_error(right, right), (SetError{3, 0, 0}));
  EXPECT_EQ(set_error({}, right), (SetError{3, 3, 0}));
}

// The paper's flip at the plane puts spheres metres away, float32 storage only flips pairs that graze.
TEST(SetErrors, AccurateMotionFindsTheRightPairs) {
  Session session({"cpu"}, {.threads = 2});
  Progress progress;
  SetPlan plan = small_plan;
  plan.motions = {{MotionMethod::paper, Precision::float32}, {MotionMethod::anchored, Precision::float64}};
  plan.steps = {4};
  plan.offsets = {1e6f};
  const auto entries = measure_motion_sets(session, plan, progress);
  ASSERT_EQ(entries.size(), 4u);
  const SetError &paper = entries[0].found, &anchored = entries[1].found, &far = entries[3].found;
  EXPECT_GT(10 * (paper.missed + paper.extra), paper.right) << "a tenth and more of the pairs are wrong";
  EXPECT_LE(100 * (anchored.missed + anchored.extra), anchored.right);
  EXPECT_EQ(entries[1].whole, (SetError{anchored.right, 0, 0}));
  EXPECT_GT(far.missed + far.extra, 0u) << "float32 positions are 6 cm apart there";
  EXPECT_EQ(entries[3].whole, (SetError{far.right, 0, 0}));
  const auto storage = measure_storage(plan, progress);
  EXPECT_GT(storage[0].error.missed + storage[0].error.extra, 0u);
  EXPECT_EQ(storage[2].error, (SetError{storage[2].error.right, 0, 0}));
}

}  // namespace
}  // namespace spherepair
