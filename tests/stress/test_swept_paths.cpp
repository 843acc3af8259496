// SPDX-License-Identifier: MIT
// Swept searches follow the paths that the motion takes, bounces within the step included: against flights and bounces
// in long double, and against the steps themselves.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "common/scene/contact_scene.h"
#include "common/scene/scene_params.h"
#include "common/shared/swept.h"
#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/paths.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

void expect_found(const std::vector<Pair>& found, const Expected& expected) {
  std::vector<Pair> missed, invented;
  std::ranges::set_difference(expected.must, found, std::back_inserter(missed));
  std::ranges::set_difference(found, expected.may, std::back_inserter(invented));
  EXPECT_TRUE(missed.empty()) << missed.size() << " missed, first " << missed[0].first << ", " << missed[0].second;
  EXPECT_TRUE(invented.empty()) << invented.size() << " invented, first " << invented[0].first << ", "
                                << invented[0].second;
}

struct Fall {
  float dt, restitution, speed, gravity = -9.81f;
  bool from_below = false;  // every eleventh sphere begins up to a metre below the plane
};

// Spheres in a flat box over the plane, radii 1:4. Every fifth rests on it, with a radius that float32 adds to the
// plane's height without rounding, but for some, which hop by that where hops end; every seventh hops by a centimetre.
Scene falling_scene(const MotionOptions& motion, const Fall& fall, uint64_t n) {
  Random random(29);
  Scene scene{.name = "falling",
              .plane = -3.25f,
              .gravity = fall.gravity,
              .dt = fall.dt,
              .restitution = fall.restitution,
              .equal_radii = false,
              .motion = motion};
  const auto any = [&](double low, double high) { return float(random.uniform(low, high)); };
  for (uint64_t i = 0; i < n; ++i) {
    const float any_radius = any(0.1, 0.4), even = std::round(any_radius * 0x1p20f) * 0x1p-20f;
    const float r = i % 15 == 0 && fall.restitution < 1 ? any_radius : even, level = scene.plane + r, v = fall.speed;
    scene.positions.push_back({any(-6, 6), level + any(0, 6), any(-6, 6), r});
    scene.velocities.push_back({any(-1, 1) * v / 8, any(-1, 0.3) * v, any(-1, 1) * v / 8, 0});
    if (i % 5 == 0) scene.positions[i].y = level, scene.velocities[i].y = 0;
    if (i % 7 == 0) scene.positions[i].y = level + 0.01f, scene.velocities[i].y = 0;
    if (i % 11 == 0 && fall.from_below)
      scene.positions[i].y = level - any(0, 1), scene.velocities[i].y = any(-1, 1) * v;
  }
  return scene;
}

const Fall falls[] = {{0.01f, 1, 1000}, {0.25f, 0.8f, 20}, {1, 1, 10},           {1, 0.5f, 5},
                      {4, 1, 2},        {0.5f, 0, 10},     {0.25f, 0.9f, 30, 0}, {0.25f, 0.7f, 6, -9.81f, true}};

class SweptPaths : public KernelTest {
 protected:
  std::vector<Pair> search(Method method = Method::automatic) {
    return run_step(backend(), {.method = method, .want_pairs = true, .swept = true}).pairs.value();
  }
  Motion::State state() {
    backend().evaluate_state();
    return backend().state();
  }
};

// In software every motion has some of the falls, by turns.
std::vector<Fall> falls_by_turns(const Backend& backend, size_t turn, size_t turns) {
  std::vector<Fall> some;
  for (size_t k = 0; k < std::size(falls); ++k)
    if (is_gpu(backend) || k % turns == turn % turns) some.push_back(falls[k]);
  return some;
}

TEST_P(SweptPaths, FollowBouncesWithinTheStep) {
  for (size_t turn = 0; const MotionOptions& motion : all_motions()) {
    if (motion.method < MotionMethod::impact_linear) continue;
    for (const Fall& fall : falls_by_turns(backend(), turn++, 2)) {
      if (fall.from_below && motion.method == MotionMethod::anchored) continue;  // below
      SCOPED_TRACE(fmt::format("{}, dt {}, restitution {}", motion_label(motion), fall.dt, fall.restitution));
      const Scene scene = falling_scene(motion, fall, 200);
      backend().upload(scene);
      for (int step = 0; step < 2; ++step) {
        const Motion::State now = state();
        std::vector<OraclePath> paths;
        for (uint64_t i = 0; i < scene.size(); ++i)
          paths.push_back(
              path_of(scene, now.positions[i], now.velocities[i], motion.method == MotionMethod::impact_linear));
        const Expected expected = expect_of_paths(paths, scene.dt, 1e-9L);
        const std::vector<Pair> found = search();
        expect_found(found, expected);
        if (step == 0) {
          EXPECT_GE(expected.behind_bounces, 4u);
          EXPECT_EQ(found, search(Method::collide_triangle));
        }
        backend().move();
      }
    }
  }
}

TEST_P(SweptPaths, SameAsOnTheCpu) {
  for (size_t turn = 0; const MotionOptions& motion : all_motions())
    for (const Fall& fall : falls_by_turns(backend(), turn++, 4)) {
      const Scene scene = falling_scene(motion, fall, 500);
      backend().upload(scene);
      cpu_backend().upload(scene);
      const std::vector<Pair> found = search(Method::collide_grid);
      EXPECT_EQ(found, *run_step(cpu_backend(), {.method = Method::parallel, .want_pairs = true, .swept = true}).pairs)
          << motion_label(motion) << ", dt " << fall.dt;
      EXPECT_GT(found.size(), 25u);
    }
}

// Positions of anchored do not depend on the time step, so that of smaller steps tells what touches within a large one,
// and what comes within `near`.
std::array<std::vector<Pair>, 2> touching_within(const Scene& coarse, uint64_t steps, float near) {
  constexpr uint64_t parts = 16;
  Scene fine = coarse;
  fine.dt = coarse.dt / parts;
  cpu_backend().upload(fine);
  for (uint64_t k = 0; k < steps * parts; ++k) cpu_backend().move();
  std::array<std::set<Pair>, 2> found;
  for (uint64_t k = 0; k <= parts; ++k) {
    std::vector<vec4> spheres = current_state(cpu_backend()).positions;
    for (vec4& sphere : spheres) sphere.w -= 2e-6f;  // rounding of the centres
    for (auto& pairs : found) {
      for (const Pair& pair : swept_pairs(spheres)) pairs.insert(pair);
      for (vec4& sphere : spheres) sphere.w += near / 2;
    }
    cpu_backend().move();
  }
  return {std::vector<Pair>(found[0].begin(), found[0].end()), std::vector<Pair>(found[1].begin(), found[1].end())};
}

// From below the plane, too: near it for a while, then as if a flight from it had ended.
TEST_P(SweptPaths, OfAnchoredAreThoseOfSmallerSteps) {
  for (const bool from_below : {false, true})
    for (const float gravity : {-9.81f, 0.0f}) {
      const Fall fall{0.25f, 0.7f, 6, gravity, from_below};
      const Scene scene = falling_scene({MotionMethod::anchored, Precision::float64}, fall, 400);
      for (const uint64_t step : {0u, 3u}) {
        const auto [must, may] = touching_within(scene, step, 2 * fall.speed * fall.dt + 0.1f);
        EXPECT_GT(must.size(), 100u);
        backend().upload(scene);
        for (uint64_t k = 0; k < step; ++k) backend().move();
        expect_found(search(), {must, may});
      }
    }
}

// A sphere falls onto the plane and comes back to one that hangs above; without the plane it only falls.
TEST_P(SweptPaths, FindWhatTouchesBehindTheBounce) {
  for (const float restitution : {1.0f, 0.4f}) {
    Scene scene{.name = "bounce",
                .positions = {{0, 1, 0, 0.5f}, {0, 3.5f, 0, 0.5f}},
                .velocities = {{0, -40, 0, 0}, {0, 0, 0, 0}},
                .plane = 0,
                .dt = 0.125f,
                .restitution = restitution,
                .motion = {MotionMethod::impact, Precision::float32}};
    backend().upload(scene);
    EXPECT_EQ(search().size(), restitution == 1 ? 1u : 0u);
    EXPECT_FALSE(touch_within(scene.positions[0], scene.velocities[0], scene.positions[1], scene.velocities[1],
                              motion_params(scene), 1, 0));  // in free flight: w is PATH_STRAIGHT
  }
}

// Methods without bounces within the step, and contacts: each sphere goes straight to where the step leaves it, seen
// from the frame that falls as all do.
TEST_P(SweptPaths, LeadStraightToTheNextStep) {
  std::vector<Scene> scenes;
  for (const MotionOptions& motion : all_motions())
    if (motion.method < MotionMethod::impact_linear) scenes.push_back(falling_scene(motion, {0.25f, 0.8f, 20}, 300));
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::hertz})
    scenes.push_back(gas({.ratio = 2, .gravity = -10, .law = law, .steps_a_contact = 12}));
  for (const Scene& scene : scenes) {
    SCOPED_TRACE(motion_label(scene.motion));
    backend().upload(scene);
    for (int step = 0; step < 12; ++step) {
      const Motion::State from = state();
      const std::vector<Pair> found = search();
      backend().move();
      const Motion::State to = state();
      std::vector<OraclePath> paths;
      for (uint64_t i = 0; i < scene.size(); ++i) {
        const vec4 &p = from.positions[i], &q = to.positions[i];
        const Float dt = scene.dt;
        // What is put on the plane at the end of the step may have been below it before.
        const bool put = scene.motion.method == MotionMethod::paper_clamp && Float(q.y) - q.w < scene.plane + 1e-5L;
        paths.push_back({p.x,
                         p.z,
                         (Float(q.x) - p.x) / dt,
                         (Float(q.z) - p.z) / dt,
                         p.w,
                         put ? Float(100) : 0,
                         {{0, p.y, (Float(q.y) - p.y) / dt, 0}}});
      }
      Expected expected = expect_of_paths(paths, scene.dt, 4e-6L);
      std::erase_if(expected.must,
                    [&](const Pair& pair) { return paths[pair.first].wander + paths[pair.second].wander > 0; });
      expect_found(found, expected);
    }
  }
}

// Spheres at rest that another, or the plane, pushes within the step onto one that they do not touch yet.
TEST_P(SweptPaths, TakeTheImpulsesOfContacts) {
  const auto pushed = [](float first, float second) {
    Scene scene{.name = "pushed",
                .positions = {{0, 9, 0, 0.5f},
                              {0.9f, 9, 0, 0.5f},
                              {first, 9, 0, 0.5f},
                              {0, 0.45f, 9, 0.5f},
                              {0, second, 9, 0.5f}},
                .velocities = std::vector<vec4>(5),
                .plane = 0,
                .gravity = 0};
    choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e6f});
    return scene;
  };
  const Motion::State alone = run_steps(cpu_backend(), pushed(5, 5), 1);
  const float along = alone.positions[1].x - 0.9f, up = alone.positions[3].y - 0.45f;
  EXPECT_GT(along, 1e-4f);
  EXPECT_GT(up, 1e-4f);
  backend().upload(pushed(1.9f + along / 2, 1.45f + up / 2));
  EXPECT_EQ(search(), (std::vector<Pair>{{0, 1}, {1, 2}, {3, 4}}));
  EXPECT_EQ(run_step(backend(), {.method = Method::automatic}).totals.pairs, 1u);
  backend().upload(pushed(1.9f + 2 * along, 1.45f + 2 * up));
  EXPECT_EQ(search(), (std::vector<Pair>{{0, 1}}));
}

INSTANTIATE_BACKENDS(SweptPaths);

}  // namespace
}  // namespace spherepair
