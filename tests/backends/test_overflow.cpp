// SPDX-License-Identifier: MIT
// Lists that outgrow their first capacity: nothing may be lost, whichever of them overflows, nor when it happens twice.
#include "tests/oracle/oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// Half the spheres at one point, half at another exactly `distance` away: n*n/4 pairs that the filter cannot decide
// when the distance is that of touching, give or take an ulp.
Scene two_points(uint64_t n, float distance) {
  std::vector<vec4> spheres(n, vec4{0, 0, 0, 0.5f});
  for (uint64_t i = 1; i < n; i += 2) spheres[i].z = distance;
  return scene_of(std::move(spheres));
}

class Overflow : public KernelTest {};

// A quarter of its square are undecided pairs, half of it colliding ones; lists begin with room for 4096.
uint64_t many(const Backend& backend) { return is_gpu(backend) ? 3000 : 1000; }

// Collisions of two_points by what they are: within a point always, across when the points overlap.
std::vector<Pair> expected_of(uint64_t n, bool across) {
  std::vector<Pair> pairs;
  for (uint i = 0; i < n; ++i)
    for (uint j = i + 1; j < n; ++j)
      if (across || i % 2 == j % 2) pairs.push_back({i, j});
  return pairs;
}

TEST_P(Overflow, UndecidedPairsBeyondTheList) {
  const uint64_t n = many(backend());
  const Scene scene = two_points(n, 1);
  expect_pairs(backend(), scene, expected_of(n, false), every_method(backend(), block_sizes().subspan(2, 1)));
  backend().upload(scene);
  const StepResult answer = run_step(backend(), fast_method(backend()));
  EXPECT_EQ(answer.totals.deferred, n * n / 4) << "all of them tangent";
  EXPECT_EQ(answer.totals.decided_by[STAGE_INTEGER], n * n / 4);
}

TEST_P(Overflow, UndecidedAndCollidingPairsBeyondBothLists) {
  const uint64_t n = many(backend());
  const Scene scene = two_points(n, 1 - 0x1p-24f);
  expect_pairs(backend(), scene, expected_of(n, true), every_method(backend(), block_sizes().subspan(2, 1)));
}

TEST_P(Overflow, CollidingPairsBeyondTheList) {
  const uint64_t n = many(backend());
  const Scene scene = make_scene({.name = "coincident", .n = n});
  expect_pairs(backend(), scene, expected_of(n, true), every_method(backend(), block_sizes().subspan(2, 1)));
}

TEST_P(Overflow, UnequalRadii) {
  const uint64_t n = is_gpu(backend()) ? 2000 : 900;
  Scene scene = two_points(n, 1);
  for (uint64_t i = 0; i < n; ++i) scene.positions[i].w = i % 2 == 0 ? 0.25f : 0.75f;
  scene.equal_radii = false;
  expect_pairs(backend(), scene, expected_of(n, false), every_method(backend(), block_sizes().subspan(2, 1)));
}

// The first overflow in the middle of a run: the step is repeated, the motion is not.
TEST_P(Overflow, MotionIsNotRepeated) {
  const Scene scene = two_points(many(backend()), 1);
  backend().upload(scene);
  backend().move();
  backend().move();
  CollideOptions options = fast_method(backend());
  options.want_pairs = true;
  const StepResult answer = run_step(backend(), options);
  EXPECT_EQ(first_mismatch(answer, swept_pairs(current_state(backend()).positions), scene.size()), "");
  const Motion::State grown = current_state(backend());
  backend().upload(scene);
  backend().move();
  backend().move();
  const Motion::State plain = current_state(backend());
  EXPECT_EQ(state_hash(grown.positions, grown.velocities), state_hash(plain.positions, plain.velocities));
}

INSTANTIATE_BACKENDS(Overflow);

}  // namespace
}  // namespace spherepair
