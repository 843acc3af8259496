// SPDX-License-Identifier: MIT
// Contacts against what kinetic theory knows of a gas of hard spheres: its pressure, and how it cools. Short runs; with
// STRESS=full on a GPU as many spheres as make walls and fluctuations small.
#include <cmath>
#include <numbers>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

class ContactPhysics : public BackendTest {
 protected:
  // The other software renderer has the CPU's bits (Contacts), at a twentieth of its speed.
  void SetUp() override {
    BackendTest::SetUp();
    if (IsSkipped()) return;
    if (backend().info().software) GTEST_SKIP() << "the same bits as the CPU's";
  }
};

bool in_full(const Backend& backend) { return is_gpu(backend) && full_stress(); }
uint64_t spheres_of(const Backend& backend) { return in_full(backend) ? 27'000 : 1000; }

struct Gas {
  Scene scene;
  double diameter, mass;
};

// A gas at rest with its walls: as long as sound takes to cross the box some times, and dense gases some times more.
// Its restitution is then set.
Gas gas_of(Backend& backend, uint64_t n, double packing_fraction, float restitution) {
  Gas gas{make_scene({.name = "gas", .n = n, .packing_fraction = packing_fraction}), 0, 0};
  choose_contacts(gas.scene, {.law = ContactLaw::spring});
  gas.diameter = 2 * double(gas.scene.positions[0].w);
  gas.mass = sphere_mass(gas.diameter / 2);
  const double seconds =
      (in_full(backend) ? 2 : 0.8) * double(gas.scene.contact.high.x);  // at two metres a second and more
  backend.upload(gas.scene);
  for (double left = seconds; left > 0; left -= double(gas.scene.dt)) backend.move();
  const Backend::State state = current_state(backend);
  gas.scene.positions = state.positions, gas.scene.velocities = state.velocities;
  gas.scene.restitution = restitution;
  backend.upload(gas.scene);
  return gas;
}

// Packing fraction away from the walls, where centres stand in layers: a smooth window, longer than these are thick.
double bulk_fraction(const Gas& gas, const std::vector<vec4>& positions) {
  const double from = 2 * gas.diameter, length = double(gas.scene.contact.high.x) - 2 * from;
  const auto weight = [&](float x) {
    const double at = (double(x) - from) / length;
    return at > 0 && at < 1 ? std::pow(std::sin(std::numbers::pi * at), 2) : 0;
  };
  double inside = 0;
  for (const vec4& p : positions) inside += weight(p.x) * weight(p.y) * weight(p.z);
  return inside * std::numbers::pi / 6 * std::pow(2 * gas.diameter / length, 3);  // the window's mean is 1/2
}

ContactStatistics statistics_of(Backend& backend, const Gas& gas) {
  backend.collide({.want_pairs = true});
  return contact_statistics(gas.scene, current_state(backend).wide, backend.pairs(), 0);
}

double temperature(double kinetic, uint64_t n) { return 2 * kinetic / (3 * double(n)); }  // times Boltzmann's constant

// p / (n k T) of Carnahan and Starling, J. Chem. Phys. 51 (1969) 635, and their contact value.
double compressibility(double f) { return (1 + f + f * f - f * f * f) / std::pow(1 - f, 3); }
double contact_value(double f) { return (1 - f / 2) / std::pow(1 - f, 3); }

// Of a hard wall that the centres reach, times d^2 / k T: Reiss, Frisch, Helfand, Lebowitz, J. Chem. Phys. 32 (1960)
// 119.
double surface_tension(double f) { return -9 / (2 * std::numbers::pi) * f * f * (1 + f) / std::pow(1 - f, 3); }

// In a box that the centres reach over a length l, 2 K + virial = 3 (p l^3 - 4 tension l^2).
TEST_P(ContactPhysics, PressureIsThatOfCarnahanAndStarling) {
  const uint64_t n = spheres_of(backend());
  for (const double fraction : in_full(backend()) ? std::vector{0.1, 0.3, 0.45} : std::vector{0.3}) {
    const Gas gas = gas_of(backend(), n, fraction, 1);
    constexpr int samples = 120;
    double sum = 0, heat = 0, bulk = 0;
    for (int sample = 0; sample < samples; ++sample) {
      for (int step = 0; step < 100; ++step) backend().move();
      const ContactStatistics now = statistics_of(backend(), gas);
      sum += (2 * now.kinetic + now.virial) / samples;
      heat += temperature(now.kinetic, n) / samples;
      bulk += bulk_fraction(gas, current_state(backend()).positions) / samples;
    }
    const double length = double(gas.scene.contact.high.x) / gas.diameter - 1;  // in diameters
    const double pressure = sum / heat / (3 * std::pow(length, 3)) + 4 * surface_tension(bulk) / length;
    const double found = pressure / (bulk * 6 / std::numbers::pi), expected = compressibility(bulk);
    EXPECT_NEAR(found / expected, 1, in_full(backend()) ? 0.02 : 0.06) << "packing fraction " << bulk << " in the bulk";
  }
}

// Haff, J. Fluid Mech. 134 (1983) 401: T = T0 / (1 + t / tau)^2, with Enskog's collision rate.
TEST_P(ContactPhysics, CoolsByHaffsLaw) {
  const uint64_t n = spheres_of(backend());
  for (const float restitution : in_full(backend()) ? std::vector{0.9f, 0.8f} : std::vector{0.8f}) {
    const Gas gas = gas_of(backend(), n, 0.3, restitution);
    const double first = statistics_of(backend(), gas).kinetic, speed = std::sqrt(temperature(first, n) / gas.mass);
    const double lost = 1 - double(restitution) * double(restitution);
    const auto tau = [&](double bulk) {
      const double density = bulk * 6 / std::numbers::pi / gas.diameter;  // times the squared diameter
      return 3 / (2 * lost * density * contact_value(bulk) * std::sqrt(std::numbers::pi) * speed);
    };
    const uint64_t steps = uint64_t((in_full(backend()) ? 2 : 1) * tau(0.3) / double(gas.scene.dt));
    double bulk = 0;
    constexpr uint64_t samples = 100;
    for (uint64_t sample = 0; sample < samples; ++sample) {
      for (uint64_t step = 0; step < steps / samples; ++step) backend().move();
      bulk += bulk_fraction(gas, current_state(backend()).positions) / samples;
    }
    const double seconds = double(steps / samples * samples) * double(gas.scene.dt);
    const double expected = first / std::pow(1 + seconds / tau(bulk), 2);
    const double found = statistics_of(backend(), gas).kinetic;
    EXPECT_NEAR(found / expected, 1, 0.05) << restitution << ", packing fraction " << bulk << " in the bulk";
    EXPECT_LT(found, 0.3 * first);
  }
}

INSTANTIATE_BACKENDS(ContactPhysics);

}  // namespace
}  // namespace spherepair
