// SPDX-License-Identifier: MIT
// Contacts against what kinetic theory knows of a gas of hard spheres: its pressure, and how it cools. The CPU's short
// runs; on a GPU as many spheres as make walls and fluctuations small.
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
    if (backend().info().software) GTEST_SKIP() << "the same bits as the CPU's";
  }
};

struct Gas {
  Scene scene;
  double diameter, mass;
};

Gas gas_of(uint64_t n, double packing_fraction, float restitution) {
  Gas gas{make_scene({.name = "gas", .n = n, .packing_fraction = packing_fraction}), 0, 0};
  gas.scene.restitution = restitution;
  choose_contacts(gas.scene, {.law = ContactLaw::spring});
  gas.diameter = 2 * double(gas.scene.positions[0].w);
  gas.mass = sphere_mass(gas.diameter / 2);
  return gas;
}

// Packing fraction away from the walls, where centres stand in layers.
double bulk_fraction(const Gas& gas, const std::vector<vec4>& positions) {
  const double layers = 3 * gas.diameter, side = double(gas.scene.contact.high.x);
  uint64_t inside = 0;
  for (const vec4& p : positions) {
    const auto within = [&](float x) { return double(x) > layers && double(x) < side - layers; };
    inside += within(p.x) && within(p.y) && within(p.z);
  }
  return double(inside) * std::numbers::pi / 6 * std::pow(gas.diameter / (side - 2 * layers), 3);
}

ContactStatistics statistics_of(Backend& backend, const Gas& gas) {
  backend.collide({.want_pairs = true});
  return contact_statistics(gas.scene, current_state(backend).wide, backend.pairs(), 0);
}

double temperature(double kinetic, uint64_t n) { return 2 * kinetic / (3 * double(n)); }  // times Boltzmann's constant

// p / (n k T) of Carnahan and Starling, J. Chem. Phys. 51 (1969) 635, and their contact value.
double compressibility(double f) { return (1 + f + f * f - f * f * f) / std::pow(1 - f, 3); }
double contact_value(double f) { return (1 - f / 2) / std::pow(1 - f, 3); }

TEST_P(ContactPhysics, PressureIsThatOfCarnahanAndStarling) {
  const bool gpu = is_gpu(backend());
  const uint64_t n = gpu ? 32768 : 1000;
  for (const double fraction : gpu ? std::vector{0.1, 0.3, 0.45} : std::vector{0.3}) {
    const Gas gas = gas_of(n, fraction, 1);
    const int samples = gpu ? 200 : 60;
    double pressure = 0, heat = 0, bulk = 0;
    backend().upload(gas.scene);
    for (int step = 0; step < 3000; ++step) backend().move();
    for (int sample = 0; sample < samples; ++sample) {
      for (int step = 0; step < 100; ++step) backend().move();
      const ContactStatistics now = statistics_of(backend(), gas);
      const double reached = double(gas.scene.contact.high.x) - gas.diameter;  // by centres
      pressure += (2 * now.kinetic + now.virial) / (3 * std::pow(reached, 3));
      heat += temperature(now.kinetic, n);
      bulk += bulk_fraction(gas, current_state(backend()).positions) / samples;
    }
    const double density = bulk * 6 / std::numbers::pi / std::pow(gas.diameter, 3);
    const double found = pressure / (density * heat), expected = compressibility(bulk);
    EXPECT_NEAR(found / expected, 1, gpu ? 0.02 : 0.05) << "packing fraction " << bulk << " in the bulk";
  }
}

// Haff, J. Fluid Mech. 134 (1983) 401: T = T0 / (1 + t / tau)^2, with Enskog's collision rate.
TEST_P(ContactPhysics, CoolsByHaffsLaw) {
  const bool gpu = is_gpu(backend());
  const uint64_t n = gpu ? 100'000 : 1000;
  for (const float restitution : gpu ? std::vector{0.95f, 0.9f} : std::vector{0.8f}) {
    const Gas gas = gas_of(n, 0.3, restitution);
    backend().upload(gas.scene);
    const double first = statistics_of(backend(), gas).kinetic, speed = std::sqrt(temperature(first, n) / gas.mass);
    const double lost = 1 - double(restitution) * double(restitution);
    const auto tau = [&](double bulk) {
      const double density = bulk * 6 / std::numbers::pi / gas.diameter;  // times the squared diameter
      return 3 / (2 * lost * density * contact_value(bulk) * std::sqrt(std::numbers::pi) * speed);
    };
    const double until = gpu ? 5 : 1;
    const uint64_t steps = uint64_t(until * tau(0.3) / double(gas.scene.dt));
    double bulk = 0;
    constexpr int samples = 40;
    for (int sample = 0; sample < samples; ++sample) {
      for (uint64_t step = 0; step < steps / samples; ++step) backend().move();
      bulk += bulk_fraction(gas, current_state(backend()).positions) / samples;
    }
    const double seconds = double(steps / samples * samples) * double(gas.scene.dt);
    const double expected = first / std::pow(1 + seconds / tau(bulk), 2);
    const double found = statistics_of(backend(), gas).kinetic;
    EXPECT_NEAR(found / expected, 1, gpu ? 0.05 : 0.08)
        << restitution << ", packing fraction " << bulk << " in the bulk";
    EXPECT_LT(found, 0.3 * first);
  }
}

INSTANTIATE_BACKENDS(ContactPhysics);

}  // namespace
}  // namespace spherepair
