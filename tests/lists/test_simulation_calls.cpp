// SPDX-License-Identifier: MIT
// Compares the calls of include/spherepair/simulation.h with a backend, with closed forms, and between backends.
#include <algorithm>
#include <array>
#include <cmath>

#include "api/open.h"
#include "common/scene/contact_scene.h"
#include "tests/lists/simulation_calls.h"

namespace spherepair {
namespace {

TEST(SimulationCalls, MakeTheStepsOfTheBackend) {
  for (const char* law : {"none", "spring", "hertz", "quartic"}) {
    SCOPED_TRACE(law);
    GivenSpheres spheres = three_spheres();
    sp_scene given = spheres.scene(law);
    given.gravity = 9.81, given.plane = 0.125;
    Scene scene{.name = "the same"};
    for (size_t i = 0; i < 3; ++i) {
      const auto at = [&](const std::vector<double>& rows, size_t axis) { return float(rows[3 * i + axis]); };
      scene.positions.push_back(
          {at(spheres.positions, 0), at(spheres.positions, 1), at(spheres.positions, 2), float(spheres.radii[i])});
      scene.velocities.push_back({at(spheres.velocities, 0), at(spheres.velocities, 1), at(spheres.velocities, 2), 0});
    }
    scene.plane = 0.125f, scene.gravity = -9.81f, scene.equal_radii = false;
    scene.motion = {MotionMethod::anchored, Precision::float32};
    choose_contacts(scene, {.law = contact_from_name(law)});
    OpenSimulation opened(given);
    ASSERT_EQ(opened.status, SP_OK) << opened.message();
    EXPECT_EQ(sp_simulation_dt(opened.simulation), double(scene.dt));
    const auto backend = open_backend("cpu");
    backend->upload(scene);
    for (const uint64_t steps : {0, 1, 700}) {
      opened.move(steps);
      for (uint64_t k = 0; k < steps; ++k) backend->move();
      const auto state = current_state(*backend);
      const std::vector<float> found = opened.state(3);
      for (size_t i = 0; i < 3; ++i) {
        const vec4 &x = state.positions[i], &v = state.velocities[i];
        EXPECT_EQ(std::vector(found.begin() + 6 * i, found.begin() + 6 * i + 6),
                  (std::vector{x.x, x.y, x.z, v.x, v.y, v.z}));
      }
    }
    EXPECT_EQ(sp_simulation_steps(opened.simulation), 701u);
  }
}

TEST(SimulationCalls, ABallBouncesOnAParabola) {
  GivenSpheres ball{.positions = {1, 5.5, 0}, .velocities = {0.25, 0, 0}, .radii = {0.5}};
  sp_scene given = ball.scene();
  given.gravity = 8, given.dt = 1.0 / 64, given.restitution = 0.5;
  OpenSimulation opened(given);
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  const double fall = std::sqrt(2 * 5.0 / 8);  // seconds to the plane, which it leaves at half of its speed
  for (int k = 0; k < 2; ++k) {
    opened.move(64);
    const double t = k + 1.0, since = t - fall, up = 0.5 * 8 * fall;
    const double height = t < fall ? 5.5 - 4 * t * t : 0.5 + up * since - 4 * since * since;
    const std::vector<double> found = opened.state<double>(1);
    EXPECT_NEAR(found[0], 1 + 0.25 * t, 1e-6);
    EXPECT_NEAR(found[1], height, 4e-6) << t;
    EXPECT_NEAR(found[4], t < fall ? -8 * t : up - 8 * since, 4e-6) << t;
  }
}

TEST(SimulationCalls, SpheresReboundAsTheirRestitutionSays) {
  GivenSpheres pair{.positions = {0, 9, 0, 1.25, 9, 0}, .velocities = {1, 0, 0, -1, 0, 0}, .radii = {0.5, 0.5}};
  sp_scene given = pair.scene("spring");
  given.restitution = 0.5;
  OpenSimulation opened(given);
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  opened.move(uint64_t(0.5 / sp_simulation_dt(opened.simulation)));
  const std::vector<double> found = opened.state<double>(2);
  EXPECT_NEAR(found[9] - found[3], 0.5 * 2, 0.02);
  EXPECT_NEAR(found[9] + found[3], 0, 1e-6);
}

TEST(SimulationCalls, WallsHoldSpheresAndDragSlowsThem) {
  GivenSpheres ball{.positions = {0, 0, 0}, .velocities = {4, 0, 0}, .radii = {0.25}, .walls = {-1, -1, -1, 1, 1, 1}};
  sp_scene given = ball.scene("hertz");
  OpenSimulation closed(given);
  ASSERT_EQ(closed.status, SP_OK) << closed.message();
  const auto steps_of = [](const OpenSimulation& opened, double seconds) {
    return uint64_t(seconds / sp_simulation_dt(opened.simulation));
  };
  double farthest = 0;
  for (int k = 0; k < 200; ++k)
    closed.move(steps_of(closed, 0.005)), farthest = std::max(farthest, std::abs(closed.state<double>(1)[0]));
  EXPECT_NEAR(farthest, 0.75, 0.02);
  ball.walls.clear();
  given = ball.scene("hertz");
  given.drag = 2, given.plane = -9;
  OpenSimulation slowed(given);
  ASSERT_EQ(slowed.status, SP_OK) << slowed.message();
  slowed.move(steps_of(slowed, 0.5));
  EXPECT_NEAR(slowed.state<double>(1)[3], 4 * std::exp(-1), 0.01);
}

TEST(SimulationCalls, SpheresCrossTheFacesOfAPeriodicBox) {
  GivenSpheres two{.positions = {1.5, 0, 0, -1.9, 0, 0},
                   .velocities = {4, 0, 0, 0, 0, 0},
                   .radii = {0.25, 0.25},
                   .walls = {-2, -1, -1, 2, 1, 1}};
  sp_scene given = two.scene("hertz");
  given.periodic[0] = 1;
  OpenSimulation opened(given);
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  bool touched = false;
  for (int k = 0; k < 40; ++k) {
    opened.move(uint64_t(0.01 / sp_simulation_dt(opened.simulation)));
    sp_pairs* list = nullptr;
    ASSERT_EQ(sp_simulation_pairs(opened.simulation, &list), SP_OK) << opened.message();
    touched = touched || list->count == 1;
    sp_free(list);
  }
  const std::vector<double> found = opened.state<double>(2);
  EXPECT_NEAR(found[9], 4, 0.01) << "the other sphere has the speed";
  EXPECT_NEAR(found[3], 0, 0.01);
  EXPECT_NEAR(found[0], 1.6, 0.02) << "where they touched";
  EXPECT_LT(found[6], 2);
}

TEST(SimulationCalls, PairsAreThoseThatOverlap) {
  GivenSpheres row{.positions = {0, 1, 0, 0.75, 1, 0, 1.75, 1, 0, 2.5, 1, 0}, .radii = {0.5, 0.5, 0.5, 0.5}};
  OpenSimulation opened(row.scene());
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  sp_pairs* list = nullptr;
  ASSERT_EQ(sp_simulation_pairs(opened.simulation, &list), SP_OK) << opened.message();
  ASSERT_EQ(list->count, 2) << "0 and 1, 2 and 3; 1 and 2 touch";
  const auto first = static_cast<const int32_t*>(list->first.data),
             second = static_cast<const int32_t*>(list->second.data);
  EXPECT_EQ((std::array{first[0], second[0], first[1], second[1]}), (std::array{0, 1, 2, 3}));
  sp_free(list);
}

TEST(SimulationCalls, EveryBackendHasTheSameBits) {
  GivenSpheres spheres = three_spheres();
  sp_scene given = spheres.scene("spring");
  given.gravity = 9.81;
  OpenSimulation expected(given);
  ASSERT_EQ(expected.status, SP_OK) << expected.message();
  expected.move(300);
  for (int32_t k = 0; const char* name = sp_backend_name(k); ++k) {
    OpenSimulation other(given, name);
    if (other.status == SP_E_BACKEND) continue;  // it is not here
    ASSERT_EQ(other.status, SP_OK) << other.message();
    other.move(300);
    EXPECT_EQ(other.state(3), expected.state(3)) << name;
  }
}

}  // namespace
}  // namespace spherepair
