// SPDX-License-Identifier: MIT
// Numbers that leave float32: what cannot be moved is refused before a step, a state that is not finite after one by
// the name of its sphere, and cells and collision steps have an end even so.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "common/plan/plan_watch.h"
#include "common/shared/cell.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
constexpr float INFINITE = std::numeric_limits<float>::infinity();
constexpr float LARGEST = std::numeric_limits<float>::max();

// A share of the spheres with such numbers for some of their coordinates.
std::vector<std::vector<vec4>> samples_that_left_float32() {
  const std::vector<vec4> sound = make_scene({.name = "uniform", .n = 500, .radius_ratio = 20}).positions;
  std::vector<std::vector<vec4>> samples;
  for (const float x : {NOT_A_NUMBER, INFINITE, -INFINITE, LARGEST, -LARGEST})
    for (const float y : {0.0f, NOT_A_NUMBER, -INFINITE, LARGEST})
      for (const size_t every : {size_t(1), size_t(2), sound.size()}) {
        samples.push_back(sound);
        for (size_t i = 0; i < sound.size(); i += every) {
          samples.back()[i].x = x;
          samples.back()[i].y = i % 3 == 0 ? y : -y;
          if (i % 5 == 0) samples.back()[i].z = NOT_A_NUMBER;
        }
      }
  return samples;
}

void expect_a_cell_for_each(const std::vector<vec4>& spheres, const GridPlans& plans) {
  for (const Cells cells : {Cells::dense, Cells::hashed}) {
    const GridPlan& plan = plans.plan(cells);
    EXPECT_TRUE(std::isfinite(plan.side) && plan.side > 0) << plan.side;
    EXPECT_LE(plan.slots, std::max(slots_per_sphere * spheres.size(), least_slots));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(plan.size[axis], 1u);
      EXPECT_TRUE(std::isfinite(plan.origin[axis]));
    }
    Params p{};
    p.grid = grid_params(plan);
    for (const vec4& sphere : spheres) ASSERT_LT(slot_of(sphere, p.grid), plan.slots);
  }
}

TEST(NonFinitePlans, HaveACellForEverySphere) {
  for (const std::vector<vec4>& sample : samples_that_left_float32())
    expect_a_cell_for_each(sample, plan_grids(sample));
}

TEST(NonFinitePlans, AreMadeAnewForSpheresThatLeftFloat32) {
  const Scene scene = make_scene({.name = "uniform", .n = 500, .radius_ratio = 20});
  for (const std::vector<vec4>& sample : samples_that_left_float32()) {
    GridPlans plans = plan_grids(scene.positions);
    expect_a_cell_for_each(sample, plan_grids_anew(plans, sample, sample.size()));
    PlanWatch watch(scene, plans);
    if (watch.worthwhile(sample, plans)) watch.replan(sample, sample.size(), plans);
    expect_a_cell_for_each(sample, plans);
  }
}

class NonFiniteOf : public KernelTest {
 protected:
  // As a run goes on from there: the numbers of a start are bounded, those that a motion has led to only finite.
  void resume(const Scene& scene) {
    backend().upload(scene);
    const MotionState start = backend().save();
    backend().resume(scene, start);
  }
};

Scene static_scene(MotionOptions motion, float x, float speed) {
  Scene scene = make_scene({.name = "uniform", .n = 40, .motion = motion});
  scene.positions[7].x = x;
  scene.velocities[9].z = speed;
  return scene;
}

TEST_P(NonFiniteOf, ASceneAtRestMayHoldAnyFiniteNumberButIsNotMoved) {
  for (const MotionOptions& motion : all_motions())
    for (const auto& [x, speed, sphere] : {std::tuple(LARGEST, 0.0f, 7), std::tuple(0.0f, -0x1.1p60f, 9)}) {
      backend().upload(static_scene(motion, x, speed));
      EXPECT_GT(run_step(backend(), fast_method(backend())).totals.pairs, 0u);
      try {
        backend().move();
        ADD_FAILURE() << motion_label(motion) << " moves it";
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(fmt::format("sphere {}", sphere)), std::string::npos) << error.what();
      }
    }
}

TEST_P(NonFiniteOf, TimeStepsBeyondTheBoundsAreNotTaken) {
  for (const float dt : {0.0f, 0x1p-61f, 0x1.1p20f, 3.4e38f, INFINITE, NOT_A_NUMBER}) {
    Scene scene = make_scene({.n = 5});
    scene.dt = dt;
    backend().upload(scene);
    EXPECT_THROW(backend().move(), std::invalid_argument) << dt;
  }
}

// The largest that may be moved, in all directions, from above the plane and below it.
Scene extreme_scene(MotionOptions motion, float dt, float restitution) {
  Scene scene = make_scene({.name = "uniform", .n = 27, .motion = motion, .dt = dt, .restitution = restitution});
  const float numbers[3] = {-0x1p60f, 1, 0x1p60f};
  for (uint i = 0; i < scene.size(); ++i) {
    scene.positions[i] = {numbers[i % 3], numbers[i / 3 % 3], numbers[(i + 1) % 3], i % 2 ? 0x1p60f : 0.5f};
    scene.velocities[i] = {numbers[(i + 2) % 3], numbers[i / 9 % 3], numbers[i % 3], 0};
  }
  scene.equal_radii = false;
  return scene;
}

TEST_P(NonFiniteOf, WithinTheBoundsEveryStateIsFinite) {
  for (const MotionOptions& motion : all_motions())
    for (const float dt : {0x1p-60f, 0x1p20f})
      for (const float restitution : {0.0f, 0.75f, 1.0f}) {
        const Scene scene = extreme_scene(motion, dt, restitution);
        const std::string where = fmt::format("{}, dt {}, restitution {}", motion_label(motion), dt, restitution);
        const Motion::State state = run_steps(backend(), scene, 40);
        for (const std::vector<vec4>* part : {&state.positions, &state.velocities})
          for (const vec4& v : *part)
            ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) << where;
        expect_equal_states(state, run_steps(cpu_backend(), scene, 40), where);
      }
}

bool finite_centre(const vec4& s) { return std::isfinite(s.x) && std::isfinite(s.y) && std::isfinite(s.z); }

// Every method, in every kind of cells; what is not finite collides with nothing.
void expect_steps_that_end(Backend& backend, const std::string& where) {
  const uint block = 128;
  std::vector<CollideOptions> configuration = every_method(backend, {&block, 1});
  for (const Cells cells : {Cells::dense, Cells::hashed})
    configuration.push_back({.method = Method::collide_grid, .grid = {.cells = cells}});
  for (CollideOptions options : configuration) {
    options.want_pairs = true;
    const StepResult answer = run_step(backend, options);
    const Motion::State state = current_state(backend);
    for (size_t i = 0; i < state.positions.size(); ++i)
      ASSERT_TRUE(finite_centre(state.positions[i]) || answer.counts[i] == 0) << where << ", " << describe(options);
    backend.check_guards();
  }
}

TEST_P(NonFiniteOf, CollisionStepsOfSpheresThatLeaveFloat32End) {
  for (const MotionOptions motion : {MotionOptions{MotionMethod::paper, Precision::float32},
                                     {MotionMethod::impact, Precision::compensated},
                                     {MotionMethod::anchored, Precision::float64}})
    for (const uint every : {1u, 4u}) {
      Scene scene = make_scene({.name = "uniform", .n = 90, .motion = motion, .restitution = 0.5f});
      scene.dt = 4;
      for (uint i = 0; i < scene.size(); i += every) {
        const float speed = i % 3 == 0 ? -3e38f : 3e38f;
        scene.velocities[i] = {speed, i % 2 ? speed : -speed, i % 5 ? 0 : speed, 0};
      }
      resume(scene);
      for (int step = 1; step <= 3; ++step) {
        backend().move();
        if (step == 2) continue;
        expect_steps_that_end(backend(), fmt::format("{}, step {}", motion_label(motion), step));
      }
      uint64_t left = 0;
      for (const vec4& sphere : current_state(backend()).positions) left += !finite_centre(sphere);
      EXPECT_GT(left, 0u) << motion_label(motion) << ": this test sees no state that left float32";
    }
}

INSTANTIATE_BACKENDS(NonFiniteOf);

}  // namespace
}  // namespace spherepair
