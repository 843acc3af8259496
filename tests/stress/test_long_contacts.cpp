// SPDX-License-Identifier: MIT
// Contacts over many steps: back to the first bits, momentum and energy kept, the CPU's states all along. Short runs;
// with STRESS=full those of 4,096 spheres and 100,000 steps, of the energy on a GPU a million.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

class LongContacts : public KernelTest {
 protected:
  bool full() { return full_stress(); }
  uint64_t steps() { return full() ? 100'000 : 300; }
  uint64_t rounds() { return full() ? 100 : 10; }

  // Elastic, in its box, at the time step that is chosen by default; in the short form of soft spheres.
  Scene elastic_gas() {
    if (!full()) return gas({.side = 5, .ratio = 2, .law = ContactLaw::spring});
    Scene scene = make_scene({.name = "gas", .n = 4096, .packing_fraction = 0.3});
    choose_contacts(scene, {.law = ContactLaw::spring});
    return scene;
  }
};

std::vector<uint> positions_of(const std::vector<uint>& wide) {
  return {wide.begin(), wide.begin() + ptrdiff_t(wide.size() / 2)};
}

TEST_P(LongContacts, GoBackToTheFirstBits) {
  const Scene scene = elastic_gas();
  const std::vector<uint> first = positions_of(fixed_state(scene));
  EXPECT_EQ(positions_of(there_and_back(backend(), scene, steps(), false)), first);
  EXPECT_NE(positions_of(there_and_back(backend(), scene, steps(), true)), first) << "a contact was dropped";
}

// Radii 1:8, in the short form 1:2; only walls change the sum of the momenta, by their impulses.
TEST_P(LongContacts, KeepTheMomentum) {
  const Scene scene = gas({.side = 6, .ratio = full() ? 8.0f : 2.0f, .law = ContactLaw::spring});
  const ContactParams c = contact_params(scene);
  const uint64_t n = scene.size();
  backend().upload(scene);
  std::vector<uint> before = backend().save().wide;
  uint64_t pushed = 0;  // by other spheres alone
  for (uint64_t step = 0; step < steps(); ++step) {
    backend().move();
    std::vector<uint> now = backend().save().wide;
    Push walls{0, 0, 0, FAULTS}, changes = walls;
    for (uint64_t i = 0; i < n; ++i) {
      const Body was = load_body(before, scene.positions, i), is = load_body(now, scene.positions, i);
      const Push wall = push_of_walls(was, false, c);
      walls.x += wall.x, walls.y += wall.y, walls.z += wall.z;
      changes.x += is.px - was.px, changes.y += is.py - was.py, changes.z += is.pz - was.pz;
      pushed += is.px != was.px && wall.x == 0;
    }
    ASSERT_EQ((std::array{changes.x, changes.y, changes.z}), (std::array{walls.x, walls.y, walls.z}))
        << "step " << step;
    before.swap(now);
  }
  EXPECT_GT(pushed, n);
}

// A round's change of the energy, over the energy: the slope of least squares, and the half width of its 95 % interval
// for a walk, since what contacts leave over adds up at random: its variance is 6/5 of a round's over their number.
struct Slope {
  double a_round, half_width;
};
Slope slope_of(const std::vector<double>& energies) {
  const double rounds = double(energies.size() - 1);
  double slope = 0, squares = 0;
  for (size_t k = 0; k < energies.size(); ++k) slope += (double(k) - rounds / 2) * energies[k] / energies[0];
  slope *= 12 / (rounds * (rounds + 1) * (rounds + 2));
  for (size_t k = 1; k < energies.size(); ++k)
    squares += std::pow((energies[k] - energies[k - 1]) / energies[0] - slope, 2);
  return {slope, 1.96 * std::sqrt(1.2 * squares / (rounds - 1) / rounds)};
}

TEST_P(LongContacts, KeepTheEnergy) {
  const Scene scene = elastic_gas();
  const uint64_t each = !full() ? 100 : is_gpu(backend()) ? 10'000 : 1000;
  backend().upload(scene);
  std::vector<double> energies;
  for (uint64_t round = 0; round <= rounds(); ++round) {
    backend().collide({.want_pairs = true});
    energies.push_back(contact_statistics(scene, current_state(backend()).wide, backend().pairs(), 0).energy());
    EXPECT_NEAR(energies.back() / energies[0], 1, 1e-3) << "round " << round;
    for (uint64_t step = 0; step < each; ++step) backend().move();
  }
  const Slope slope = slope_of(energies);
  const double in_all = double(rounds() * each), drift = slope.a_round * double(rounds());
  fmt::print("{}: energy changed by {:.2e} of it in {} steps, slope {:.2e} +- {:.1e} a million steps\n",
             backend().info().name, energies.back() / energies[0] - 1, in_all, slope.a_round / double(each) * 1e6,
             slope.half_width / double(each) * 1e6);
  EXPECT_LT(std::abs(slope.a_round), slope.half_width) << "a drift";
  EXPECT_LT(std::abs(drift) + slope.half_width * double(rounds()), 3e-4);
}

// Halfway they go on from a checkpoint.
TEST_P(LongContacts, EqualThoseOfTheCpu) {
  if (backend().info().on_host) GTEST_SKIP() << "the CPU itself";
  const Scene scene = elastic_gas();
  cpu_backend().upload(scene);
  backend().upload(scene);
  for (uint64_t round = 1; round <= rounds(); ++round) {
    for (uint64_t step = 0; step < steps() / rounds(); ++step) cpu_backend().move(), backend().move();
    expect_equal_states(current_state(backend()), current_state(cpu_backend()), fmt::format("round {}", round));
    if (HasFailure()) break;
    if (round == rounds() / 2) backend().resume(with(scene, current_state(backend())), backend().save());
  }
}

INSTANTIATE_BACKENDS(LongContacts);

}  // namespace
}  // namespace spherepair
