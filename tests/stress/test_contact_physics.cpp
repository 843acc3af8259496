// SPDX-License-Identifier: MIT
// Contacts against what kinetic theory knows of a gas of hard spheres: its pressure, and how it cools. Short runs; with
// STRESS=full on a GPU as many spheres as make walls and fluctuations small.
#include "bench/check/gas.h"
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

// A gas at rest with its walls: a dense one takes longer.
Gas gas_of(Backend& backend, double packing_fraction, float restitution) {
  Scene scene = make_scene({.name = "gas", .n = spheres_of(backend), .packing_fraction = packing_fraction});
  choose_contacts(scene, {.law = ContactLaw::spring});
  return equilibrated_gas(backend, scene, (in_full(backend) ? 2 : 0.8) * double(scene.contact.high.x), restitution);
}

TEST_P(ContactPhysics, PressureIsThatOfCarnahanAndStarling) {
  for (const double fraction : in_full(backend()) ? std::vector{0.1, 0.3, 0.45} : std::vector{0.3}) {
    const Pressure pressure = measure_pressure(backend(), gas_of(backend(), fraction, 1), 120, 100);
    EXPECT_NEAR(pressure.found / pressure.expected, 1, in_full(backend()) ? 0.02 : 0.06)
        << "packing fraction " << pressure.packing_fraction << " in the bulk";
  }
}

TEST_P(ContactPhysics, CoolsByHaffsLaw) {
  for (const float restitution : in_full(backend()) ? std::vector{0.9f, 0.8f} : std::vector{0.8f}) {
    const Gas gas = gas_of(backend(), 0.3, restitution);
    const double kinetic = double(gas.scene.size()) * gas.mass / 2;  // at the start: a third each axis
    const double seconds = (in_full(backend()) ? 2 : 1) * expected_tau(gas, 0.3, kinetic);
    constexpr uint64_t samples = 100;
    const Cooling cooling =
        measure_cooling(backend(), gas, samples, uint64_t(seconds / double(gas.scene.dt)) / samples);
    EXPECT_NEAR(cooling.last / cooling.expected_last(), 1, 0.05)
        << restitution << ", packing fraction " << cooling.packing_fraction << " in the bulk";
    EXPECT_LT(cooling.last, 0.3 * cooling.first);
  }
}

INSTANTIATE_BACKENDS(ContactPhysics);

}  // namespace
}  // namespace spherepair
