// SPDX-License-Identifier: MIT
//
// Moves spheres in C++20: simulation.h with spans, an owner and exceptions. That header has the laws and the units.
//
//   spherepair::Simulation simulation({.positions = positions, .radii = radii, .contact = "spring"});
//   simulation.move(1000);
//   const auto [positions, velocities] = simulation.state();
#pragma once

#include <spherepair/simulation.h>
#include <spherepair/spherepair.hpp>
#include <vector>

namespace spherepair {

using Row = std::array<float, 3>;

// The corners of a closed box, whose floor is the plane.
struct Walls {
  std::array<double, 3> low, high;
};

// Where spheres start; sp_scene explains each field.
struct Scene {
  Points positions = {};                        // N x 3, m
  Points velocities = {};                       // N x 3, m/s; not given: at rest
  Numbers radii = {};                           // N, m
  double plane = 0, gravity = 9.81;             // m; m/s^2, downwards
  double restitution = 1, dt = 0;               // 0 to 1; s, 0: chosen
  std::string contact = "none";                 // or spring, hertz, quartic
  double stiffness = 0, density = 0, drag = 0;  // 0: chosen; kg/m^3, 0: water; 1/s
  std::optional<Walls> walls = {};
};

// Moves a scene on a backend of its own. One thread at a time may use it. All members throw Error.
class Simulation {
 public:
  struct State {
    std::vector<Row> positions, velocities;
  };

  explicit Simulation(const Scene& scene, const std::string& backend = "auto", const std::string& device = "",
                      int32_t threads = 0) {
    const sp_scene start = {.size = sizeof(sp_scene),
                            .positions = scene.positions.array(),
                            .velocities = scene.velocities.array(),
                            .radii = scene.radii.array(),
                            .plane = scene.plane,
                            .gravity = scene.gravity,
                            .restitution = scene.restitution,
                            .dt = scene.dt,
                            .contact = scene.contact.c_str(),
                            .stiffness = scene.stiffness,
                            .density = scene.density,
                            .drag = scene.drag,
                            .walls = scene.walls ? detail::host_array(&scene.walls->low, SP_F64, 2, 3, 3) : sp_array{}};
    sp_simulation* opened = nullptr;
    const sp_status status =
        sp_simulation_open(backend.c_str(), device.empty() ? nullptr : device.c_str(), threads, &start, &opened);
    simulation_.reset(opened);
    check(status);
    spheres_ = size_t(scene.positions.array().rows);
  }

  void move(uint64_t steps = 1) { check(sp_simulation_move(simulation_.get(), steps)); }
  double dt() const { return sp_simulation_dt(simulation_.get()); }          // seconds of a step
  uint64_t steps() const { return sp_simulation_steps(simulation_.get()); }  // made so far

  // Reads the state, rounded to float32.
  State state() {
    State found{std::vector<Row>(spheres_), std::vector<Row>(spheres_)};
    const auto array = [&](std::vector<Row>& rows) {
      return detail::host_array(rows.data(), SP_F32, int64_t(rows.size()), 3, 3);
    };
    const sp_array positions = array(found.positions), velocities = array(found.velocities);
    check(sp_simulation_state(simulation_.get(), &positions, &velocities));
    return found;
  }

  // Lists the pairs i < j of spheres that overlap now.
  PairList pairs() {
    sp_pairs* list = nullptr;
    check(sp_simulation_pairs(simulation_.get(), &list));
    return PairList(list);
  }

 private:
  struct Close {
    void operator()(sp_simulation* simulation) const { sp_simulation_close(simulation); }
  };
  void check(sp_status status) const {
    if (status != SP_OK) throw Error(status, sp_simulation_message(simulation_.get()));
  }

  std::unique_ptr<sp_simulation, Close> simulation_;
  size_t spheres_ = 0;
};

}  // namespace spherepair
