// SPDX-License-Identifier: MIT
// Drag against the solution of m dv/dt = m g - drag m v, over its whole range.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

class ContactDrag : public KernelTest {};

struct Flight {
  double speed = 1, drag = 1, dt = 1e-4, radius = 0.5, gravity = 0, stiffness = 1e7;
};

// Far above the plane; the other sphere sets the ratio of radii.
Scene flying(const Flight& flight, double ratio = 1) {
  const float small = float(flight.radius), large = float(ratio * flight.radius);
  Scene scene = scene_of({{0, 40, 0, small}, {0, 40 + 2 * (small + large), 0, large}});
  scene.plane = 0, scene.gravity = float(flight.gravity);
  scene.velocities = {{float(flight.speed), 0, 0, 0}, {}};
  choose_contacts(scene, {.law = ContactLaw::spring,
                          .stiffness = float(flight.stiffness),
                          .dt = float(flight.dt),
                          .drag = float(flight.drag)});
  return scene;
}

// Positions in metres, of the integers.
double along_x(const Scene& scene, const Motion::State& state) {
  return std::ldexp(double(word(state.wide, 0)), -scene.contact.unit_exponent);
}

// The velocity is that of half a step before the position.
void expect_closed_form(const Scene& scene, const Motion::State& state, uint64_t steps, const std::string& where) {
  const double drag = double(scene.contact.drag), dt = double(scene.dt), t = double(steps) * dt,
               v = double(scene.velocities[0].x), g = double(scene.gravity);
  const double way = -std::expm1(-drag * t) / drag;
  EXPECT_NEAR(along_x(scene, state) / (v * way), 1, 0.01) << where;
  EXPECT_NEAR(double(state.velocities[0].x) / (v * std::exp(-drag * (t - dt / 2))), 1, 0.01) << where;
  const ContactStatistics start = contact_statistics(scene, fixed_state(scene), {}, 0),
                          sums = contact_statistics(with(scene, state), state.wide, {}, steps);
  EXPECT_NEAR((1 - sums.momentum[0] / start.momentum[0]) / -std::expm1(-drag * t), 1, 0.01) << where << ": loss";
  const double mass = sphere_mass(double(scene.positions[0].w)), other = sphere_mass(double(scene.positions[1].w));
  const double vx = v * std::exp(-drag * t), vy = g * way;
  EXPECT_NEAR(sums.momentum[0] / (mass * vx), 1, 0.01) << where;
  if (g != 0) {
    EXPECT_NEAR(sums.momentum[1] / ((mass + other) * vy), 1, 0.01) << where;
  }
  EXPECT_NEAR(sums.kinetic / (mass * vx * vx / 2 + (mass + other) * vy * vy / 2), 1, 0.02) << where;
}

TEST_P(ContactDrag, IsThatOfTheClosedForm) {
  const Flight flights[] = {{},
                            {.drag = 1e-4},
                            {.drag = 1e-3},
                            {.drag = 4000},
                            {.speed = 3, .drag = 20, .gravity = -9.81},
                            {.speed = 3, .drag = 3000, .gravity = -9.81},
                            {.drag = 7, .dt = 1e-3, .gravity = -9.81, .stiffness = 1e5},
                            {.drag = 1, .dt = 1e-7},
                            {.speed = 0.011, .drag = 2e4, .dt = 1.3e-5},
                            {.speed = 30, .drag = 0.3, .dt = 1e-6, .radius = 0.003}};
  for (const Flight& flight : flights) {
    const Scene scene = flying(flight);
    ASSERT_EQ(why_no_contacts(scene), "");
    for (const uint64_t steps : {1u, 2u, 40u, 700u}) {
      if (flight.drag * flight.dt * double(steps) > 4) continue;  // few units of momentum are left
      expect_closed_form(scene, run_steps(backend(), scene, steps), steps,
                         fmt::format("drag {}, dt {}, {} steps", flight.drag, flight.dt, steps));
    }
  }
}

// Numbers that a message advises are accepted.
TEST(ContactDragRange, IsRightOrRefused) {
  std::mt19937 random(11);
  const auto power = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  uint64_t right = 0, refused = 0;
  for (int turn = 0; turn < 1500; ++turn) {
    const double radius = power(1e-3, 3), dt = power(1e-11, 1e-3), ratio = turn % 2 ? 1 : power(1, 256);
    Flight flight{.speed = power(1e-5, 30), .dt = dt, .radius = radius};
    flight.stiffness = sphere_mass(radius) / (dt * dt) / power(30, 3000);
    flight.drag = power(1e-9, 0.7) / dt;
    Scene scene = flying(flight, ratio);
    for (const auto& [advice, complaint] :
         {std::pair("can be 0 to ", "can be 0"), {"give --dt ", "stays in place"}, {"give --drag ", "too weak"}}) {
      const std::string why = why_no_contacts(scene);
      const size_t at = why.find(advice);
      if (why.find(complaint) == std::string::npos || at == std::string::npos) continue;
      ++refused;
      const double advised = std::stod(why.substr(at + std::string(advice).size()));
      if (std::string(complaint) == "stays in place")
        flight.dt = advised, flight.stiffness = sphere_mass(radius) / (advised * advised) / 300;
      else
        flight.drag = advised;
      scene = flying(flight, ratio);
      EXPECT_EQ(why_no_contacts(scene).find(complaint), std::string::npos) << why << "\n" << why_no_contacts(scene);
    }
    if (!why_no_contacts(scene).empty()) continue;
    ++right;
    const uint64_t steps = uint64_t(std::min(200.0, std::ceil(1 / (double(scene.contact.drag) * double(scene.dt)))));
    expect_closed_form(scene, run_steps(cpu_backend(), scene, steps), steps,
                       fmt::format("speed {}, drag {}, dt {}, radius {}, 1:{}, {} steps", flight.speed, flight.drag,
                                   flight.dt, radius, ratio, steps));
  }
  EXPECT_GT(right, 300u);
  EXPECT_GT(refused, 300u);
}

// Also where nothing moves, and of a run that goes on.
TEST(ContactDragRange, ADragThatChangesNothingIsRefused) {
  Scene scene = flying({.speed = 0});
  for (const auto& [drag, refused] : {std::pair(1e-30f, true), {1e-16f, false}}) {
    scene.contact.drag = drag;
    for (const Origin origin : {Origin::start, Origin::resumed})
      EXPECT_EQ(why_no_contacts(scene, origin).find("too weak") != std::string::npos, refused) << drag;
  }
}

INSTANTIATE_BACKENDS(ContactDrag);

}  // namespace
}  // namespace spherepair
