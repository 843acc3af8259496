// SPDX-License-Identifier: MIT
// Options of contacts over their whole ranges: what is chosen and accepted does what docs/contacts.md says, and a
// number that a refusal advises is accepted.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "common/scene/contact_scene.h"
#include "tests/oracle/world_of_scene.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

double between(double low, double high) {  // each octave as often
  const double share = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 10'001)) / 10'000.0;
  return low * std::pow(high / low, share);
}
bool either() { return *rc::gen::arbitrary<bool>(); }

ContactLaw any_law() { return *rc::gen::element(ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz); }

// Two spheres of the radii, one of which moves by the speed towards the other, which is at rest.
Scene two_spheres(double radius, double ratio, double speed) {
  const float small = float(radius), large = float(radius * ratio);
  Scene scene = {.name = "two", .plane = -8 * large, .gravity = 0, .equal_radii = small == large};
  scene.positions = {{0, 0, 0, large}, {1.01f * (small + large), 0, 0, small}};
  scene.velocities = {{}, {-float(speed), 0, 0, 0}};
  return scene;
}

// What docs/contacts.md says of the default stiffness and time step: two of the largest spheres, both at the highest
// speed, enter each other by 1 % of their radius; the shortest contact of any two radii lasts so many steps.
struct Wanted {
  Real stiffness, dt;
};
Wanted wanted_of(const Scene& scene) {
  OracleWorld world = world_of(scene);
  Real smallest = INFINITY, largest = 0, highest = 0;
  for (const OracleSphere& s : world.spheres) {
    const auto& v = s.velocity;
    const Real fall = std::max<Real>(0, s.at[1] - s.radius - world.plane);
    highest = std::max(highest, std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] - 2 * world.gravity * fall));
    smallest = std::min(smallest, s.radius), largest = std::max(largest, s.radius);
  }
  OracleWorld pair = world;
  pair.walls = {}, pair.gravity = 0, pair.stiffness = 1;
  pair.spheres = {{{0, 0, 0}, {highest, 0, 0}, largest}, {{1.99L * largest, 0, 0}, {-highest, 0, 0}, largest}};
  const OracleStatistics stopped = statistics_of(pair);
  const Real stiffness = stopped.kinetic / stopped.contact;
  Real shortest = INFINITY;
  for (const Real other : {smallest, largest}) {
    const Real mass = oracle_mass(smallest) / (1 + oracle_mass(smallest) / oracle_mass(other));
    const OracleContact contact = {world.law, stiffness, smallest, other, oracle_mass(smallest), oracle_mass(other)};
    if (world.law == OracleLaw::spring)
      shortest = std::min(shortest, std::sqrt(mass / stiffness) * damper_for(scene.restitution).seconds);
    if (world.law == OracleLaw::quartic) shortest = std::min(shortest, shallow_seconds(contact));
    if (world.law == OracleLaw::hertz)  // both at the highest speed
      shortest =
          std::min(shortest, 2.94327L * std::pow(mass * highest * highest * 5 / stiffness, 0.4L) / (2 * highest));
  }
  return {stiffness, shortest / std::max(40.0L, 60 * std::log(1 / static_cast<Real>(scene.restitution)))};
}

RC_GTEST_PROP(ContactSteps, DefaultsAreThoseOfTheDocumentation, ()) {
  const double radius = between(1e-3, 1e3), ratio = between(1, 256);
  const ContactLaw law = any_law();
  Scene scene = two_spheres(radius, ratio, radius * between(1e-3, 1e3));
  if (either()) scene.gravity = -float(radius * between(0.1, 100));
  if (law == ContactLaw::spring && either()) scene.restitution = float(between(0.1, 1));
  scene.contact.law = law;
  const Wanted wanted = wanted_of(scene);
  choose_contacts(scene, {.law = law});
  RC_LOG() << contact_name(law) << ", " << scene.contact.stiffness << ", dt " << scene.dt << '\n';
  RC_ASSERT(why_no_contacts(scene).empty());
  RC_ASSERT(std::abs(double(scene.contact.stiffness) / double(wanted.stiffness) - 1) < 1e-6);
  RC_ASSERT(std::abs(double(scene.dt) / double(wanted.dt) - 1) < 5e-5);
}

// A sphere that rests on the plane, however small: 1 % deep the plane carries it.
RC_GTEST_PROP(ContactSteps, WeightPressesInByAHundredthAtMost, ()) {
  const float radius = float(between(1e-5, 1e3));
  Scene scene = {.name = "one", .positions = {{0, radius, 0, radius}}, .velocities = {{}}, .plane = 0};
  scene.gravity = -float(between(1e-2, 1e2));
  choose_contacts(scene, {.law = any_law()});
  RC_ASSERT(why_no_contacts(scene).empty());
  OracleWorld world = world_of(scene);
  world.spheres[0].at[1] = 0.99L * world.spheres[0].radius;
  const Real weight = -oracle_mass(world.spheres[0].radius) * world.gravity;
  RC_ASSERT(statistics_of(world).floor_force > 0.98L * weight);
}

// A number behind these words; 0 where they are not there.
float number_behind(const std::string& text, const std::string& words) {
  const size_t at = text.find(words);
  return at == std::string::npos ? 0 : std::stof(text.substr(at + words.size()));
}

// Gives the number that a refusal advises; false where it advises none.
bool follow(const std::string& why, Scene& scene, ContactChoice& choice) {
  if (const float step = number_behind(why, "give --dt "); step > 0)
    choice.dt = step;
  else if (const float stiffness = number_behind(why, "give --stiffness "); stiffness > 0)
    choice.stiffness = stiffness, choice.dt = {};
  else if (const float least = number_behind(why, "must be at least "); least > 0)
    scene.restitution = least;
  else
    return false;
  choose_contacts(scene, choice);
  return true;
}

// How fast two spheres part that meet a few steps behind this start, in the speed at which they meet.
double rebound(Scene scene, uint64_t steps) {
  const double gap = 3 * double(scene.dt) * std::abs(double(scene.velocities[1].x));
  const float reach = scene.positions[0].w + scene.positions[1].w;
  scene.positions[1].x = std::nextafter(reach + float(gap), INFINITY);
  const auto& v = run_steps(cpu_backend(), scene, steps).velocities;
  return (double(v[1].x) - double(v[0].x)) / -double(scene.velocities[1].x);
}

// Any stiffness, restitution, time step, radii and speed: two spheres rebound as the equations of motion say, or the
// start is refused; what the refusal advises is accepted, and right.
RC_GTEST_PROP(ContactSteps, WhatIsAcceptedIsRightAndAdviceIsAccepted, ()) {
  const ContactLaw law = any_law();
  const double radius = between(1e-4, 1e4);
  Scene scene = two_spheres(radius, either() ? 1 : between(1, 256), radius * between(1e-2, 1e2));
  if (law == ContactLaw::spring && either()) scene.restitution = float(between(0.03, 1));
  ContactChoice choice = {.law = law};
  choose_contacts(scene, choice);
  if (either()) choice.stiffness = scene.contact.stiffness * float(between(1e-6, 1e10));
  choose_contacts(scene, choice);
  if (either()) choice.dt = scene.dt * float(between(1e-5, 100));
  choose_contacts(scene, choice);
  std::vector<std::string> refusals;
  for (std::string why; !(why = why_no_contacts(scene)).empty();) {
    refusals.push_back(why);
    RC_LOG() << why << '\n';
    const std::string kind = why.substr(0, why.find_first_of("0123456789"));
    RC_ASSERT(refusals.size() < 5u);  // a smaller stiffness goes with another time step, which can be refused
    if (refusals.size() > 1) RC_ASSERT(!refusals.end()[-2].starts_with(kind));
    if (!follow(why, scene, choice)) break;
  }
  RC_CLASSIFY(refusals.empty(), "accepted");
  const double steps = contact_time(scene) / double(scene.dt), asked = double(scene.restitution);
  if (!why_no_contacts(scene).empty() || steps > 1000) return;
  const double coarse = 3 / (steps * steps), damped = std::max(0.02, 1.1 * std::log(1 / asked) / steps);
  const double found = rebound(scene, uint64_t(8 * steps) + 20);
  RC_LOG() << contact_name(law) << ", restitution " << asked << ", " << steps << " steps: " << found << '\n';
  RC_ASSERT(std::abs(found / asked - 1) < (asked < 1 ? damped : 1e-3) + coarse);
}

// A small sphere would pass through a large one in silence: its impulses round to nothing.
TEST(ContactSteps, StepsTooShortForIntegersAreRefused) {
  Scene scene = two_spheres(0.5, 256, 1);
  choose_contacts(scene, {.law = ContactLaw::spring});
  choose_contacts(scene, {.law = ContactLaw::spring, .dt = 0.003f * scene.dt});
  const float advised =
      number_behind(why_no_contacts(scene), "a sphere of radius 0.5 m at 1 m/s by too few units: give --dt ");
  ASSERT_GT(advised, scene.dt);
  choose_contacts(scene, {.law = ContactLaw::spring, .dt = advised});
  EXPECT_EQ(why_no_contacts(scene), "");
  EXPECT_NEAR(rebound(scene, uint64_t(3 * contact_time(scene) / double(scene.dt))), 1, 1e-3);
}

}  // namespace
}  // namespace spherepair
