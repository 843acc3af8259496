// SPDX-License-Identifier: MIT
// Statistics of contacts against sums over all pairs in float64, and against closed forms.
#include <algorithm>
#include <cmath>

#include "bench/check/contact_statistics.h"
#include "common/scene/contact_scene.h"
#include "tests/support/motion_runs.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

// What a step from this state on does: pairs by an exact search, the state before and after.
struct Moment {
  Motion::State now, later;
  std::vector<Pair> pairs;
};

Moment moment_of(const Scene& scene, uint64_t steps) {
  Backend& backend = cpu_backend();
  Moment m{run_steps(backend, scene, steps), {}, {}};
  backend.collide({.method = Method::parallel, .want_pairs = true});
  m.pairs = backend.pairs();
  backend.move();
  m.later = current_state(backend);
  return m;
}

ContactStatistics statistics_of(const Scene& scene, const Moment& m) {
  return contact_statistics(scene, m.now.wide, m.pairs, 7);
}

// Without the code under test: positions and momenta in metres and kg m/s, every pair and wall, the laws as written.
struct Sums {
  double kinetic = 0, contact = 0, potential = 0, momentum = 0, greatest_overlap = 0;
  uint64_t contacts = 0, wall_contacts = 0;
};

Sums sums_of(const Scene& scene, const Moment& m) {
  Sums sums;
  const ContactOptions& contact = scene.contact;
  const double metre = std::exp2(-contact.unit_exponent), unit = std::exp2(-contact.momentum_exponent);
  const auto store = [&](double reach, double distance, uint64_t& count) {
    const double overlap = reach - distance, k = double(contact.stiffness);
    if (overlap <= 0) return;
    ++count;
    sums.greatest_overlap = std::max(sums.greatest_overlap, overlap);
    sums.contact += contact.law == ContactLaw::spring  ? k / 2 * overlap * overlap
                    : contact.law == ContactLaw::hertz ? k * 2 / 5 * std::pow(overlap, 2.5)
                                                       : k / 4 * std::pow(reach * reach - distance * distance, 2);
  };
  const auto body = [&](const std::vector<uint>& wide, uint64_t i) { return load_body(wide, scene.positions, i); };
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const Body now = body(m.now.wide, i), later = body(m.later.wide, i);
    const double r = double(now.radius), mass = 1000 * 4 * M_PI / 3 * r * r * r;
    const double p[3] = {unit * (double(now.px) + double(later.px)) / 2, unit * (double(now.py) + double(later.py)) / 2,
                         unit * (double(now.pz) + double(later.pz)) / 2};
    sums.kinetic += (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2 * mass);
    sums.momentum += p[1];
    const double x[3] = {metre * double(now.x), metre * double(now.y), metre * double(now.z)};
    sums.potential += mass * -double(scene.gravity) * (x[1] - double(scene.plane));
    store(r, x[1] - double(scene.plane), sums.wall_contacts);
    store(r, x[0] - double(contact.low.x), sums.wall_contacts);
    store(r, x[2] - double(contact.low.z), sums.wall_contacts);
    store(r, double(contact.high.x) - x[0], sums.wall_contacts);
    store(r, double(contact.high.y) - x[1], sums.wall_contacts);
    store(r, double(contact.high.z) - x[2], sums.wall_contacts);
    for (uint64_t j = 0; j < i; ++j) {
      const Body other = body(m.now.wide, j);
      store(r + double(other.radius), metre * std::hypot(now.x - other.x, now.y - other.y, now.z - other.z),
            sums.contacts);
    }
  }
  return sums;
}

TEST(ContactStatistics, AreTheSumsOverAllPairs) {
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz}) {
    Scene scene = gas({.ratio = 1.25f, .gravity = -9.81f, .law = law});
    if (law == ContactLaw::spring) scene.restitution = 0.8f;
    uint64_t contacts = 0, wall_contacts = 0;
    for (uint64_t steps = 120; steps <= 720; steps += 20) {
      const Moment m = moment_of(scene, steps);
      const ContactStatistics found = statistics_of(scene, m);
      const Sums wanted = sums_of(scene, m);
      contacts += found.contacts, wall_contacts += found.wall_contacts;
      EXPECT_EQ(found.contacts, wanted.contacts);
      EXPECT_EQ(found.wall_contacts, wanted.wall_contacts);
      EXPECT_NEAR(found.kinetic / wanted.kinetic, 1, 1e-12) << contact_name(law);
      EXPECT_NEAR(found.contact, wanted.contact, 1e-9 * wanted.contact) << contact_name(law);
      EXPECT_NEAR(found.potential / wanted.potential, 1, 1e-9) << contact_name(law);
      EXPECT_NEAR(found.momentum[1] / wanted.momentum, 1, 1e-9) << contact_name(law);
      EXPECT_NEAR(found.greatest_overlap, wanted.greatest_overlap, 1e-9) << contact_name(law);
      EXPECT_EQ(found.energy(), found.kinetic + found.contact + found.potential);
      EXPECT_EQ(found.step, 7u);
      EXPECT_EQ(found.seconds, 7 * double(scene.dt));
    }
    EXPECT_GT(contacts, 0u) << contact_name(law);
    EXPECT_GT(wall_contacts, 10u) << contact_name(law);
  }
}

// Two spheres that overlap by a tenth, one of which presses a plane: forces are known.
TEST(ContactStatistics, VirialAndForceOnThePlaneAreThoseOfTheLaw) {
  Scene scene{.name = "two",
              .positions = {{0, 0.4375f, 0, 0.5f}, {0.9f, 0.4375f, 0, 0.5f}},
              .velocities = {{}, {}},
              .plane = 0,
              .gravity = 0};
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e6f});
  const ContactStatistics found = statistics_of(scene, moment_of(scene, 0));
  const double distance = double(0.9f), k = 1e6;
  EXPECT_NEAR(found.virial, k * (1 - distance) * distance, 1e-6 * found.virial);
  EXPECT_NEAR(found.floor_force, 2 * k * 0.0625, 1e-6 * found.floor_force);
  EXPECT_NEAR(found.greatest_overlap, 1 - distance, 1e-12);
  EXPECT_EQ(found.contacts, 1u);
  EXPECT_EQ(found.wall_contacts, 2u);
}

TEST(ContactStatistics, TextHasNamesUnitsAndAllDigits) {
  ContactStatistics row;
  row.step = 3, row.kinetic = 0.1, row.momentum = {1.0 / 3, 0, -2}, row.contacts = 5;
  EXPECT_EQ(statistics_heading() + statistics_row(row),
            "step,time_s,kinetic_J,contact_J,potential_J,momentum_x_kg_m_per_s,momentum_y_kg_m_per_s,"
            "momentum_z_kg_m_per_s,greatest_overlap_m,contacts,wall_contacts,virial_J,floor_force_N\n"
            "3,0,0.1,0,0,0.3333333333333333,0,-2,0,5,0,0,0\n");
}

// Of the energy from the first, over four contact times of so many steps, read 20 times in each.
double greatest_deviation(const Scene& scene, int steps) {
  Backend& backend = cpu_backend();
  backend.upload(scene);
  double first = 0, greatest = 0;
  for (int k = 0; k <= 80; ++k) {
    backend.collide({.want_pairs = true});
    const double energy = contact_statistics(scene, current_state(backend).wide, backend.pairs(), 0).energy();
    if (k == 0) first = energy;
    greatest = std::max(greatest, std::abs(energy / first - 1));
    for (int step = 0; step < steps / 20; ++step) backend.move();
  }
  return greatest;
}

// In the mean of many gases: the error that a contact leaves depends on where in a step it begins.
TEST(ContactStatistics, ErrorsOfTheEnergyFallWithTheSquareOfTheStep) {
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::hertz, ContactLaw::quartic}) {
    double last = 0;
    for (const int steps : {20, 40, 80}) {
      double sum = 0;
      for (uint seed = 0; seed < 24; ++seed)
        sum += greatest_deviation(gas({.side = 5, .law = law, .steps_a_contact = double(steps), .seed = seed}), steps);
      if (last > 0) {
        EXPECT_NEAR(last / sum, 4, 0.4) << contact_name(law) << ", " << steps << " steps";
      }
      last = sum;
    }
  }
}

// The plane gives a falling sphere what changes its momentum in the next step, less its weight: also by the damper.
TEST(ContactStatistics, TheForceOnThePlaneIsThatOfTheNextStep) {
  Scene scene = scene_of({{0, 0.499f, 0, 0.5f}});
  scene.plane = 0, scene.restitution = 0.3f, scene.velocities[0].y = -1;
  choose_contacts(scene, {.law = ContactLaw::spring});
  const Moment m = moment_of(scene, 0);
  const auto momentum = [&](const Motion::State& state) {
    return std::ldexp(double(load_body(state.wide, scene.positions, 0).py), -scene.contact.momentum_exponent);
  };
  const double weight = sphere_mass(0.5) * -double(scene.gravity);
  const double wanted = (momentum(m.later) - momentum(m.now)) / double(scene.dt) + weight;
  EXPECT_NEAR(statistics_of(scene, m).floor_force / wanted, 1, 1e-6);
  scene.restitution = 1;
  EXPECT_LT(statistics_of(scene, m).floor_force, 0.9 * wanted) << "without a damper";
}

// The search goes by float32 centres, between which rounding can hide a gap.
TEST(ContactStatistics, APairThatIsApartInIntegersIsNoContact) {
  Scene scene = scene_of({{0, 4, 0, 0.5f}, {1, 4, 0, 0.5f}});
  scene.plane = 0;
  choose_contacts(scene, {.law = ContactLaw::spring});
  std::vector<uint> wide = fixed_state(scene);
  const Pair pair{0, 1};
  for (const int64_t gap : {1, 0, -1}) {
    Body second = load_body(wide, scene.positions, 1);
    second.x = (int64_t(1) << scene.contact.unit_exponent) + gap;
    store_body(wide, 2, 1, second);
    EXPECT_EQ(contact_statistics(scene, wide, {&pair, 1}, 0).contacts, gap < 0 ? 1u : 0u) << gap;
  }
}

}  // namespace
}  // namespace spherepair
