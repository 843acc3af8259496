// SPDX-License-Identifier: MIT
// Builds scenes and opens simulations through the C calls.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "include/spherepair/simulation.h"

namespace spherepair {

// Owns the arrays that a scene points to.
struct GivenSpheres {
  std::vector<double> positions, velocities = {}, radii;
  std::vector<double> walls = {};

  sp_scene scene(const char* contact = nullptr) {
    const auto array = [](std::vector<double>& numbers, int64_t columns) {
      return numbers.empty()
                 ? sp_array{}
                 : sp_array{numbers.data(), int64_t(numbers.size()) / columns, columns, columns, 1, SP_F64, 1, 0};
    };
    sp_scene made = {};
    made.size = sizeof made;
    made.positions = array(positions, 3), made.velocities = array(velocities, 3);
    made.radii = array(radii, 1), made.walls = array(walls, 3);
    made.restitution = 1, made.contact = contact;
    return made;
  }
};

inline GivenSpheres three_spheres() {
  return {.positions = {0, 1, 0, 0.05, 2.25, 0, 3, 1.5, 0.25},
          .velocities = {0.5, 0, 0, 0, -1, 0, -0.25, 2, 0},
          .radii = {0.5, 0.5, 0.375}};
}

class OpenSimulation {
 public:
  explicit OpenSimulation(const sp_scene& scene, const char* backend = "cpu") {
    status = sp_simulation_open(backend, nullptr, 0, &scene, &simulation);
  }
  OpenSimulation(const std::string& checkpoint, const char* backend) {
    status = sp_simulation_resume_bytes(backend, nullptr, 0, checkpoint.data(), checkpoint.size(), &simulation);
  }
  OpenSimulation() = default;
  ~OpenSimulation() { sp_simulation_close(simulation); }
  OpenSimulation(const OpenSimulation&) = delete;
  OpenSimulation& operator=(const OpenSimulation&) = delete;

  std::string message() const { return sp_simulation_message(simulation); }
  void move(uint64_t steps) { ASSERT_EQ(sp_simulation_move(simulation, steps), SP_OK) << message(); }
  // Positions, then velocities, of each sphere.
  template <typename Number = float>
  std::vector<Number> state(size_t spheres) {
    std::vector<Number> numbers(6 * spheres, -7);
    constexpr sp_type type = sizeof(Number) == 4 ? SP_F32 : SP_F64;
    const sp_array positions = {numbers.data(), int64_t(spheres), 3, 6, 1, type, 1, 0};
    const sp_array velocities = {numbers.data() + 3, int64_t(spheres), 3, 6, 1, type, 1, 0};
    EXPECT_EQ(sp_simulation_state(simulation, &positions, &velocities), SP_OK) << message();
    return numbers;
  }

  sp_simulation* simulation = nullptr;
  sp_status status = SP_OK;
};

}  // namespace spherepair
