// SPDX-License-Identifier: MIT
// Row 26 of the stress catalogue, contacts between steps: testing once a step misses as many as geometry says, the
// swept test misses none and invents none, on every backend.
#include <fmt/format.h>

#include <cmath>

#include "bench/check/missed_contacts.h"
#include "bench/check/quad.h"
#include "common/backend/swept_paths.h"
#include "common/scene/contact_scene.h"
#include "common/scene/scene_params.h"
#include "common/shared/swept.h"
#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"
#include "tests/support/catalogue.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

// Whether two spheres come nearer than `shorter` times the sum of their radii within dt, in quadruple precision.
bool touch_in_quad(const Scene& scene, uint i, uint j, const Quad& shorter = 1) {
  const vec4 &a = scene.positions[i], &b = scene.positions[j], &v = scene.velocities[i], &w = scene.velocities[j];
  const Quad p[3] = {Quad(a.x) - b.x, Quad(a.y) - b.y, Quad(a.z) - b.z};
  const Quad u[3] = {Quad(v.x) - w.x, Quad(v.y) - w.y, Quad(v.z) - w.z};
  Quad speed = 0, parting = 0, nearest = 0;
  for (int k = 0; k < 3; ++k) speed += u[k] * u[k], parting += p[k] * u[k];
  Quad time = speed > 0 ? Quad(-parting / speed) : Quad(0);
  time = std::max(Quad(0), std::min(time, Quad(scene.dt)));
  for (int k = 0; k < 3; ++k) nearest += (p[k] + u[k] * time) * (p[k] + u[k] * time);
  const Quad reach = (Quad(a.w) + b.w) * shorter;
  return nearest < reach * reach;
}

CollideOptions swept_options() { return {.method = Method::automatic, .want_pairs = true, .swept = true}; }

// Spheres that fly through each other in all directions, some tangent, some at rest relative to another.
Scene crossing_scene(uint64_t n, float dt) {
  Random random(26);
  Scene scene = make_scene({.name = "uniform", .n = n, .packing_fraction = 0.05, .dt = dt});
  scene.plane = -1000;
  const auto speed = [&] { return std::ldexp(float(random.uniform(-1, 1)), random.between(-6, 6)); };
  for (uint64_t i = 0; i < n; ++i) {
    scene.velocities[i] = {speed(), speed(), speed(), 0};
    if (i % 9 == 8) {
      scene.positions[i] = scene.positions[i - 1];
      scene.positions[i].x += 2 * scene.positions[i].w;
      if (i % 2 == 0) scene.velocities[i] = scene.velocities[i - 1];
    }
  }
  return scene;
}

TEST_P(StressCatalogue, Row26_SweptFindsWhatTouchesWithinAStep) {
  for (float dt : {0x1p-8f, 0.1f, 1.0f}) {
    const Scene scene = crossing_scene(is_gpu(backend()) ? 700 : 400, dt);
    std::vector<Pair> touching;
    uint64_t grazing = 0;
    for (uint i = 0; i < scene.size(); ++i)
      for (uint j = i + 1; j < scene.size(); ++j) {
        if (touch_in_quad(scene, i, j))
          touching.push_back({i, j});
        else
          grazing += touch_in_quad(scene, i, j, Quad(1) + 0x1p-40);
      }
    backend().upload(scene);
    const StepResult answer = run_step(backend(), swept_options());
    std::vector<Pair> missed, invented;
    std::ranges::set_difference(touching, *answer.pairs, std::back_inserter(missed));
    std::ranges::set_difference(*answer.pairs, touching, std::back_inserter(invented));
    note_figure(fmt::format("{} found, {} missed at dt = {}", touching.size(), missed.size(), dt), "0 missed");
    EXPECT_TRUE(missed.empty()) << missed.size() << " missed at dt = " << dt;
    EXPECT_LE(invented.size(), grazing) << "at dt = " << dt;
    const StepResult now = run_step(backend(), {.method = swept_options().method});
    EXPECT_GT(answer.totals.pairs, now.totals.pairs);
    cpu_backend().upload(scene);
    const StepResult by_cpu = run_step(cpu_backend(), swept_options());
    EXPECT_EQ(*answer.pairs, *by_cpu.pairs);
    EXPECT_EQ(answer.counts, by_cpu.counts);
    EXPECT_EQ(answer.totals.fingerprint, by_cpu.totals.fingerprint);
  }
}

TEST_P(StressCatalogue, Row26_DiscreteTestMissesAsGeometrySays) {
  const uint64_t pairs = is_gpu(backend()) || full_stress() ? 8192 : 600;
  for (double way : {0.5, 1.0, 2.0, 5.0}) {
    const Scene scene = passing_scene(pairs, way, 27);
    const double share = expected_miss_share(way);
    const double expected = share * double(pairs), deviation = std::sqrt(expected * (1 - share));
    const uint64_t missed = missed_pairs(backend(), scene, way, false);
    fmt::print("{}: at s = {} {} of {} contacts are missed, {:.0f} +- {:.0f} expected\n", backend().info().name, way,
               missed, pairs, expected, deviation);
    note_figure(fmt::format("{} of {} at s = {}, {:.0f} expected, swept 0", missed, pairs, way, expected), "3 sigma");
    EXPECT_NEAR(double(missed), expected, 3 * deviation);
    EXPECT_EQ(missed_pairs(backend(), scene, way, true), 0u);
  }
}

class Swept : public KernelTest {
 protected:
  std::vector<Pair> found(const CollideOptions& options = swept_options()) {
    return run_step(backend(), options).pairs.value();
  }
  // The pairs that touch within the next dt, by testing all.
  std::vector<Pair> touching_pairs(const Scene& scene) {
    backend().evaluate_state();
    const Motion::State state = backend().state();
    Params params{};
    params.motion = motion_params(scene);
    params.contact = contact_params(scene);
    const auto list = [](const Scene& grown) { return swept_pairs(grown.positions); };
    const std::vector<vec4>&at = state.positions,
          v = path_velocities(state, backend().save(), scene.motion, params, list);
    const float scale = bits_float(0x3F80000Cu);
    std::vector<Pair> touching;
    for (uint i = 0; i < at.size(); ++i)
      for (uint j = i + 1; j < at.size(); ++j)
        if (touch_within(at[i], v[i], at[j], v[j], params.motion, scale, 0x1p-100f)) touching.push_back({i, j});
    return touching;
  }
};

TEST_P(Swept, EveryMethodFindsWhatTestingAllPairsFinds) {
  for (const float dt : {0.01f, 1.0f}) {
    Scene scene = crossing_scene(by_form(backend(), 2000, 900), dt);
    scene.motion.method = MotionMethod::impact;
    scene.plane = 0;
    backend().upload(scene);
    const std::vector<Pair> touching = touching_pairs(scene);
    EXPECT_GT(touching.size(), 100u);
    for (const Method method : backend().methods()) {
      if (method == Method::collide_group) continue;
      SCOPED_TRACE(method_name(method));
      CollideOptions options = swept_options();
      options.method = method;
      EXPECT_EQ(found(options), touching);
    }
  }
}

TEST_P(Swept, OfEveryMotionAndPrecision) {
  for (const MotionOptions& motion : all_motions()) {
    SCOPED_TRACE(motion_label(motion));
    const Scene scene = bouncing_scene({.motion = motion, .dt = 0.25f, .n = 600});
    backend().upload(scene);
    for (int step = 0; step < 3; ++step) {
      const std::vector<Pair> touching = touching_pairs(scene);
      EXPECT_EQ(found(), touching);
      EXPECT_GT(touching.size(), run_step(backend(), {.method = Method::automatic}).totals.pairs);
      backend().move();
    }
  }
}

// Far from the origin, where spheres around paths lack the rounding that a skin allows for.
TEST_P(Swept, LeavesContactsAsTheyAre) {
  for (const float from : {0.0f, 100000.0f}) {
    const Scene scene = gas({.from = from});
    backend().upload(scene);
    for (int step = 0; step < 400; ++step) {
      if (step % 50 == 7) {
        EXPECT_EQ(found(), touching_pairs(scene));
      }
      backend().move();
    }
    expect_equal_states(current_state(backend()), run_steps(cpu_backend(), scene, 400), "after swept searches");
  }
}

TEST_P(Swept, BetweenOtherSearches) {
  const Scene scene = crossing_scene(9000, 0.05f);
  backend().upload(scene);
  const StepResult before = run_step(backend(), {.method = Method::collide_grid, .want_pairs = true});
  const StepResult swept = run_step(backend(), swept_options());
  EXPECT_EQ(*run_step(backend(), {.method = Method::collide_grid, .want_pairs = true}).pairs, *before.pairs);
  EXPECT_EQ(*run_step(backend(), swept_options()).pairs, *swept.pairs);
  EXPECT_GT(swept.totals.pairs, before.totals.pairs);
}

TEST_P(Swept, RefusedWhereItIsNot) {
  Scene scene = crossing_scene(50, 1);
  backend().upload(scene);
  CollideOptions options = swept_options();
  options.method = Method::collide_group;
  EXPECT_THROW(backend().collide(options), std::invalid_argument);
  options = swept_options();
  options.exact = false;
  EXPECT_THROW(backend().collide(options), std::invalid_argument);
  scene.velocities[7].y = 3e38f;
  scene.dt = 4;
  backend().upload(scene);
  try {
    backend().collide(swept_options());
    FAIL() << "a path that ends beyond float32 was searched";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("sphere 7"), std::string::npos) << refusal.what();
  }
}

INSTANTIATE_BACKENDS(Swept);

}  // namespace
}  // namespace spherepair
