// SPDX-License-Identifier: MIT
// Checks the status and the message that wrong use of include/spherepair/simulation.h gets.
#include <cmath>
#include <limits>

#include "tests/lists/simulation_calls.h"

namespace spherepair {
namespace {

TEST(SimulationCalls, WrongScenesAreRefused) {
  const auto expect = [](sp_scene scene, sp_status status, const std::string& says) {
    OpenSimulation opened(scene);
    EXPECT_EQ(opened.status, status) << says;
    EXPECT_EQ(opened.simulation, nullptr);
    EXPECT_NE(opened.message().find(says), std::string::npos) << opened.message();
    EXPECT_EQ(opened.message().find("--"), std::string::npos) << "an option of the program: " << opened.message();
  };
  const auto changed = [](const char* contact, auto change) {
    static GivenSpheres spheres;
    spheres = three_spheres();
    sp_scene scene = spheres.scene(contact);
    change(scene);
    return scene;
  };
  expect(changed(nullptr, [](sp_scene& s) { s.size = 8; }), SP_E_ARGUMENT, "scene.size is 8");
  expect(changed(nullptr, [](sp_scene& s) { s.positions = {}; }), SP_E_ARGUMENT, "positions are missing");
  expect(changed(nullptr, [](sp_scene& s) { s.radii.rows = 2; }), SP_E_ARGUMENT,
         "radii has 2 rows, but there are 3 positions");
  expect(changed(nullptr, [](sp_scene& s) { s.velocities.rows = 1; }), SP_E_ARGUMENT, "velocities has 1 rows");
  expect(changed(nullptr, [](sp_scene& s) { s.gravity = NAN; }), SP_E_NONFINITE, "gravity is not finite");
  expect(changed(nullptr, [](sp_scene& s) { s.plane = 1e300; }), SP_E_RANGE, "plane is 1e+300");
  expect(changed(nullptr, [](sp_scene& s) { s.plane = 0.75; }), SP_E_ARGUMENT,
         "sphere 0 reaches down to y = 0.5, below the plane");
  expect(changed("spring", [](sp_scene& s) { s.plane = 1.25; }), SP_E_ARGUMENT,
         "sphere 0 has its centre at y = 1, below");
  expect(changed(nullptr, [](sp_scene& s) { s.dt = -1; }), SP_E_ARGUMENT, "dt is -1 s");
  expect(changed(nullptr, [](sp_scene& s) { s.stiffness = 1; }), SP_E_ARGUMENT,
         "stiffness is given, but without a contact law");
  expect(changed("glue", [](sp_scene&) {}), SP_E_ARGUMENT, "unknown contact law 'glue'");
  expect(changed("hertz", [](sp_scene& s) { s.restitution = 0.5; }), SP_E_ARGUMENT, "the law hertz is elastic");
  expect(changed("spring", [](sp_scene& s) { s.stiffness = 1e30; }), SP_E_ARGUMENT, "give stiffness");
  expect(changed("spring", [](sp_scene& s) { s.walls = s.radii; }), SP_E_ARGUMENT, "walls has 3 rows of 1");
  expect(changed("spring", [](sp_scene& s) { s.periodic[2] = 1; }), SP_E_ARGUMENT, "no box that repeats");
  expect(changed("spring", [](sp_scene& s) { s.periodic[1] = 2; }), SP_E_ARGUMENT, "periodic[1] is 2");
  expect(changed(nullptr, [](sp_scene& s) { s.periodic[0] = 1; }), SP_E_ARGUMENT, "periodic is given, but without");
  GivenSpheres far{.positions = {0, std::numeric_limits<double>::infinity(), 0}, .radii = {1}};
  expect(far.scene(), SP_E_NONFINITE, "positions[0].y is not finite");
  sp_simulation* none = nullptr;
  EXPECT_EQ(sp_simulation_open("cpu", nullptr, 0, nullptr, &none), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_open("abacus", nullptr, 0, nullptr, nullptr), SP_E_ARGUMENT);
  const sp_scene scene = changed(nullptr, [](sp_scene&) {});
  EXPECT_EQ(sp_simulation_open("abacus", nullptr, 0, &scene, &none), SP_E_ARGUMENT);
  EXPECT_NE(std::string(sp_simulation_message(nullptr)).find("abacus"), std::string::npos);
}

TEST(SimulationCalls, AStepThatFailsIsTheLast) {
  GivenSpheres falling{.positions = {0, 1, 0, 0.5, 1, 0}, .radii = {0.002, 0.001}};
  sp_scene given = falling.scene("spring");
  given.gravity = 9.81, given.stiffness = 1e-4, given.dt = 0.004;
  OpenSimulation opened(given);
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  opened.move(6);
  EXPECT_EQ(sp_simulation_move(opened.simulation, 1), SP_E_ARGUMENT);
  EXPECT_NE(opened.message().find("step 7 of 0.004 s: sphere 0"), std::string::npos) << opened.message();
  EXPECT_EQ(sp_simulation_steps(opened.simulation), 6u);
  EXPECT_EQ(sp_simulation_state(opened.simulation, nullptr, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "a step of this simulation failed: close it");
}

TEST(SimulationCalls, TakeNothingAndWrongArrays) {
  sp_simulation_close(nullptr);
  EXPECT_EQ(sp_simulation_move(nullptr, 1), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_state(nullptr, nullptr, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_pairs(nullptr, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_simulation_dt(nullptr), 0);
  EXPECT_EQ(sp_simulation_steps(nullptr), 0u);
  GivenSpheres spheres = three_spheres();
  OpenSimulation opened(spheres.scene());
  ASSERT_EQ(opened.status, SP_OK) << opened.message();
  EXPECT_EQ(sp_simulation_pairs(opened.simulation, nullptr), SP_E_ARGUMENT);
  std::vector<float> numbers(9);
  const sp_array two_rows = {numbers.data(), 2, 3, 3, 1, SP_F32, 1, 0},
                 integers = {numbers.data(), 3, 3, 3, 1, SP_I32, 1, 0};
  EXPECT_EQ(sp_simulation_state(opened.simulation, &two_rows, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "positions has 2 rows, but there are 3 positions");
  EXPECT_EQ(sp_simulation_state(opened.simulation, nullptr, &integers), SP_E_ARGUMENT);
  EXPECT_EQ(opened.message(), "velocities is of type I32, but must be F32 or F64");
  EXPECT_EQ(sp_simulation_state(opened.simulation, nullptr, nullptr), SP_OK) << "nothing went wrong in a step";
}

}  // namespace
}  // namespace spherepair
