// SPDX-License-Identifier: MIT
// Contacts over the whole ranges of their options, compared with an oracle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/scene/contact_scene.h"
#include "tests/oracle/world_of_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr ContactLaw laws[] = {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz};

OracleContact between(ContactLaw law, long double stiffness, long double a, long double b) {
  return {oracle_law(law), stiffness, a, b, oracle_mass(a), oracle_mass(b)};
}

TEST(ContactRanges, NoPairOfRadiiHasAShorterContact) {
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::quartic})
    for (const float ratio : {1.0f, 1.1f, 1.7f, 8.0f, 64.0f, 256.0f}) {
      const Radii radii{0.5f, 0.5f * ratio};
      const double shortest = shortest_contact(law, 1e7, radii, 1);
      long double found = INFINITY;
      for (int i = 0; i <= 60; ++i)
        for (int j = i; j <= 60; ++j) {
          const auto radius = [&](int k) { return 0.5L * std::pow(static_cast<long double>(ratio), k / 60.0L); };
          found = std::min(found, shallow_seconds(between(law, 1e7L, radius(i), radius(j))));
        }
      EXPECT_NEAR(shortest / double(found), 1, 1e-7) << contact_name(law) << " 1:" << ratio;
    }
}

// The speed at which two spheres part over that at which they met. The smaller is the second.
double rebound(ContactLaw law, float ratio, double late) {
  const float large = 0.5f * ratio;
  Scene scene = {.name = "two", .plane = -4 * large, .gravity = 0, .equal_radii = ratio == 1};
  scene.positions = {{0, 0, 0, large}, {large + 0.5f, 0, 0, 0.5f}};
  scene.velocities = {{}, {-1, 0, 0, 0}};
  choose_contacts(scene, {.law = law});
  scene.positions[1].x += float((3 + late) * double(scene.dt));
  const uint64_t steps = 250;  // of which a contact of two smallest spheres lasts 40
  const Motion::State end = run_steps(cpu_backend(), scene, steps);
  return double(end.velocities[1].x) - double(end.velocities[0].x);
}

TEST(ContactRanges, ElasticSpheresPartAsTheyMet) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  for (const ContactLaw law : laws)
    for (const float ratio : {1.0f, 3.0f, 17.0f, 64.0f, 256.0f})
      for (int k = 0; k < 8; ++k) {
        const double late = part(random);
        EXPECT_NEAR(rebound(law, ratio, late), 1, 1e-3) << contact_name(law) << " 1:" << ratio << ", late " << late;
      }
}

TEST(ContactRanges, DampingGivesTheRestitutionBelowAndAboveTheCriticalValue) {
  for (double restitution = 0.1; restitution < 0.995; restitution += 0.018) {
    OracleContact contact = between(ContactLaw::spring, 1e7L, 0.5L, 0.5L);
    contact.damping =
        static_cast<long double>(damping_ratio(restitution)) * 2 * std::sqrt(1e7L * contact.first_mass / 2);
    EXPECT_NEAR(double(speed_left(contact, 1)), restitution, 2e-4) << damping_ratio(restitution);
  }
  for (const double restitution : {0.1, 0.135, 0.136, 0.5, 0.99}) {
    const OracleDamper damper = damper_for(restitution);
    EXPECT_NEAR(damping_ratio(restitution) / double(damper.damping), 1, 1e-4) << restitution;
    EXPECT_NEAR(damped_time(damping_ratio(restitution)) / double(damper.seconds), 1, 1e-5) << restitution;
  }
  EXPECT_GT(damping_ratio(0.1), 1);
  EXPECT_LT(damping_ratio(0.14), 1);
  EXPECT_EQ(damping_ratio(1), 0);
}

// Two spheres of 2^k m, one of which comes at a radius a second: they exchange their speeds, or the start is refused.
TEST(ContactRanges, AnyScaleIsRightOrRefused) {
  int right = 0;
  for (const ContactLaw law : laws)
    for (int k = -100; k <= 55; ++k) {  // planes are bounded at 2^60 m
      const float radius = std::ldexp(1.0f, k);
      Scene scene = {.name = "two", .plane = -4 * radius, .gravity = 0};
      scene.positions = {{0, 0, 0, radius}, {2.02f * radius, 0, 0, radius}};
      scene.velocities = {{}, {-radius, 0, 0, 0}};
      try {
        choose_contacts(scene, {.law = law});
        const Motion::State end = run_steps(cpu_backend(), scene, 200);
        EXPECT_NEAR(double(end.velocities[0].x) / double(radius), -1, 2e-3) << contact_name(law) << ", 2^" << k << " m";
        EXPECT_NEAR(double(end.velocities[1].x) / double(radius), 0, 2e-3) << contact_name(law) << ", 2^" << k << " m";
        ++right;
      } catch (const std::invalid_argument& refusal) {
        EXPECT_TRUE(k < -35 || k > 30) << contact_name(law) << ", 2^" << k << " m: " << refusal.what();
        const std::string said = refusal.what();
        EXPECT_TRUE(said.find("in another unit") != said.npos || said.find("dt is ") != said.npos) << said;
      }
    }
  EXPECT_GT(right, 3 * 60);
}

}  // namespace
}  // namespace spherepair
