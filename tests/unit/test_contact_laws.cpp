// SPDX-License-Identifier: MIT
// The conversions of fixed-point state, and two bodies against what is known of them exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact.h"
#include "common/shared/skin.h"
#include "tests/support/motion_runs.h"

namespace spherepair {
namespace {

TEST(FixedPoint, ConversionsAreCorrectlyRoundedAndOdd) {
  std::mt19937_64 random(64);
  for (int k = 0; k < 1'000'000; ++k) {
    const int64_t x = int64_t(random()) >> (2 + random() % 62);
    ASSERT_EQ(float_bits(float_of(x)), float_bits(float(x))) << x;
    const float f = std::ldexp(float(int64_t(random())), -int(random() % 90));
    if (std::abs(f) < 0x1p61f) {
      ASSERT_EQ(integer_of(f), std::llrint(f)) << f;
    }
  }
  EXPECT_EQ(integer_of(0x1p61f), MOST_UNITS);
  EXPECT_EQ(integer_of(-INFINITY), -MOST_UNITS);
}

TEST(FixedPoint, ProductsAreWithinOneRoundingAndOdd) {
  std::mt19937_64 random(65);
  for (int k = 0; k < 1'000'000; ++k) {
    const int64_t x = int64_t(random()) >> (3 + random() % 60);
    const float factor = std::ldexp(1 + float(random() % 8388608) * 0x1p-23f, int(random() % 90) - 70);
    const long double exact = (long double)(x) * (long double)(factor);  // 61 bits and 24: within 2^-64
    if (std::abs(exact) >= 0x1p60l) continue;
    ASSERT_NEAR(double((long double)(scaled(x, factor)) - exact), 0, 0.5 + 0x1p-3) << x << " * " << factor;
    ASSERT_EQ(scaled(-x, factor), -scaled(x, factor));
  }
}

constexpr double contact_seconds = 0x1p-6, mass = 1000 * 4 * std::numbers::pi / 3 / 8, reduced = mass / 2;

// Two spheres of radius 0.5 a contact's time before they touch, at 1 m/s to each other.
Scene two_spheres(ContactLaw law, double stiffness, double restitution, int steps_a_contact) {
  Scene scene = {.name = "two", .gravity = 0, .restitution = float(restitution)};
  const float half = 0.5f + float(contact_seconds / 2);
  scene.positions = {{-half, 0, 0, 0.5f}, {half, 0, 0, 0.5f}};
  scene.velocities = {{0.5f, 0, 0, 0}, {-0.5f, 0, 0, 0}};
  choose_contacts(scene,
                  {.law = law, .stiffness = float(stiffness), .dt = float(contact_seconds / double(steps_a_contact))});
  return scene;
}

// Centre distance after so many contact times.
double distance_after(const Scene& scene, int steps) {
  const std::vector<uint> wide = run_steps(cpu_backend(), scene, uint64_t(steps)).wide;
  const int64_t apart = load_real<int64_t>(wide, 1) - load_real<int64_t>(wide, 0);
  return std::ldexp(double(apart), -scene.contact.unit_exponent);
}

double rebound_speed(const Scene& scene, int steps) {
  const Backend::State end = run_steps(cpu_backend(), scene, uint64_t(steps));
  return double(end.velocities[1].x) - double(end.velocities[0].x);
}

TEST(ContactLaws, SpringFollowsTheClosedFormAndErrorsFallWithTheSquareOfTheStep) {
  const double k = reduced * std::pow(std::numbers::pi / contact_seconds, 2);
  const double overlap = contact_seconds / std::numbers::pi;  // greatest
  double last = 0;
  for (const int steps : {20, 40, 80}) {
    const Scene scene = two_spheres(ContactLaw::spring, k, 1, steps);
    EXPECT_NEAR(contact_time(scene), contact_seconds, 1e-8);
    const double error = std::abs((1 - distance_after(scene, steps + steps / 2)) / overlap - 1);
    EXPECT_LT(error, steps >= 40 ? 1e-3 : 4e-3) << steps;
    if (last > 0) {
      EXPECT_NEAR(last / error, 4, 0.5) << steps;
    }
    last = error;
    EXPECT_NEAR(rebound_speed(scene, 3 * steps), 1, 1e-3) << steps;
  }
}

TEST(ContactLaws, SpringLeavesTheRestitutionOfTheSpeed) {
  const double k = reduced * std::pow(std::numbers::pi / contact_seconds, 2);
  for (const double restitution : {0.9, 0.7, 0.5})
    EXPECT_NEAR(rebound_speed(two_spheres(ContactLaw::spring, k, restitution, 1280), 3 * 1280) / restitution, 1, 1e-3)
        << restitution;
}

// Their radii's sixth power is no float.
TEST(ContactLaws, SpringDampsSmallSpheresToo) {
  Scene scene = make_scene({.name = "collide2", .n = 2, .radius = 1e-7f});
  scene.restitution = 0.5f;
  choose_contacts(scene, {.law = ContactLaw::spring});
  EXPECT_NEAR(rebound_speed(scene, 400), 1, 0.01);  // together, of 2 m/s
}

TEST(ContactLaws, HertzReachesTheGreatestOverlapAndBouncesBack) {
  const double overlap = contact_seconds / 2.9432, k = 5 * reduced / (4 * std::pow(overlap, 2.5));
  for (const int steps : {40, 80}) {
    const Scene scene = two_spheres(ContactLaw::hertz, k, 1, steps);
    EXPECT_NEAR((1 - distance_after(scene, steps + steps / 2)) / overlap, 1, 1e-3) << steps;
    EXPECT_NEAR(rebound_speed(scene, 3 * steps), 1, 1e-3) << steps;
  }
}

// The overlap at which all energy is in k/4 (R^2 - d^2)^2.
TEST(ContactLaws, QuarticReachesTheGreatestOverlapAndBouncesBack) {
  const double depth = 2 * contact_seconds / std::numbers::pi, k = 2 * reduced / (depth * depth);
  const double overlap = 1 - std::sqrt(1 - depth);
  for (const int steps : {40, 80}) {
    const Scene scene = two_spheres(ContactLaw::quartic, k, 1, steps);
    double deepest = 0;
    for (int step = steps; step < 2 * steps; ++step) deepest = std::max(deepest, 1 - distance_after(scene, step));
    EXPECT_NEAR(deepest / overlap, 1, 2e-3) << steps;
    EXPECT_NEAR(rebound_speed(scene, 3 * steps), 1, 1e-3) << steps;
  }
}

// More spheres and pairs than one thread takes.
TEST(ContactLaws, SameBitsWithAnyNumberOfThreads) {
  Scene scene = make_scene({.name = "gas", .n = 20'000});
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e5f});
  Backend::State wanted;
  for (const int threads : {1, 2, 7}) {
    const auto backend = open_backend("cpu", {.threads = threads});
    const Backend::State found = run_steps(*backend, scene, 60);
    if (threads == 1) wanted = found;
    expect_equal_states(found, wanted, fmt::format("{} threads", threads));
    EXPECT_GT(run_step(*backend, fast_method(*backend)).totals.pairs, 4096u);
  }
}

// Two spheres that have come into contact since their list was made, each by less than its skin, are in the list: their
// grown spheres collided, however the centres were rounded.
TEST(ContactLaws, TheSkinCoversEveryPathAndRounding) {
  std::mt19937 random(32);
  std::uniform_real_distribution<double> any(-1, 1);
  uint64_t served = 0, contacts = 0;
  ContactParams c{};
  c.skin = 0x1p-5f;
  for (int k = 0; k < 400'000; ++k) {
    const double far = std::exp2(16 * std::abs(any(random))), radius = 0.5 * std::exp2(3 * any(random));
    double before[2][3], now[2][3], apart = 0;
    const double path = radius / (24 + 72 * std::abs(any(random)));  // some leave their skin
    vec4 centre[2], then[2];
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = far * any(random), half = radius * 1.19 * any(random);
      for (int s = 0; s < 2; ++s) {
        before[s][axis] = middle + (s ? half : -half);
        now[s][axis] = before[s][axis] + (s ? -1 : 1) * std::copysign(path * any(random), half);
      }
      apart += std::pow(now[1][axis] - now[0][axis], 2);
    }
    const auto rounded = [&](const double* at) {
      return vec4{float(at[0]), float(at[1]), float(at[2]), float(radius)};
    };
    for (int s = 0; s < 2; ++s) then[s] = grown_sphere(rounded(before[s]), c), centre[s] = rounded(now[s]);
    if (has_left_skin(centre[0], then[0]) || has_left_skin(centre[1], then[1])) continue;
    ++served;
    if (apart >= 4 * double(float(radius)) * double(float(radius))) continue;
    ++contacts;
    double square = 0;
    for (float vec4::*axis : {&vec4::x, &vec4::y, &vec4::z})
      square += std::pow(double(then[0].*axis) - double(then[1].*axis), 2);
    ASSERT_LT(square, std::pow(double(then[0].w) + double(then[1].w), 2)) << far << " m away, radius " << radius;
  }
  EXPECT_GT(served, 50'000u);
  EXPECT_GT(contacts, 10'000u);
  EXPECT_LT(contacts, served - 10'000u);
  EXPECT_TRUE(is_too_far({1e5f, 0, 0, 0.5f}, c));
  EXPECT_FALSE(is_too_far({1e4f, 0, 0, 0.5f}, c));
}

void expect_refused(const Scene& scene, int steps, const std::string& wanted) {
  try {
    run_steps(cpu_backend(), scene, uint64_t(steps));
    ADD_FAILURE() << "nothing was refused: " << wanted;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(wanted), std::string::npos) << error.what();
  }
}

TEST(ContactLaws, WhatAStepCannotDoIsNamed) {
  const double k = reduced * std::pow(std::numbers::pi / contact_seconds, 2);
  expect_refused(two_spheres(ContactLaw::spring, k, 1, 1), 1, "but a contact lasts 0.0156 s only");
  expect_refused(two_spheres(ContactLaw::quartic, k, 0.5, 40), 1, "the law quartic is elastic");
  Scene fast = two_spheres(ContactLaw::spring, k, 1, 40);
  fast.velocities[1].x = -1000;
  expect_refused(fast, 1, "sphere 1 moves at 1000 m/s, but");
  Scene deep = two_spheres(ContactLaw::spring, k, 1, 40);
  deep.positions[0].x = deep.positions[1].x - 0.25f;
  expect_refused(deep, 1, "sphere 0 is deeper in sphere 1 than the smaller radius, 0.75 m of 0.5 m");
  Scene falling = two_spheres(ContactLaw::spring, k, 1, 40);
  falling.velocities = {{-20, 0, 0, 0}, {20, 0, 0, 0}};
  falling.contact.unit_exponent = 59;
  expect_refused(falling, 20'000, "sphere 0 has left the range of float32 centres and 64-bit positions, at (-4");
  Scene beyond = two_spheres(ContactLaw::spring, k, 1, 40);
  beyond.velocities[1].y = 1e30f;
  try {
    choose_contacts(beyond, {.law = ContactLaw::spring});
    ADD_FAILURE() << "a stiffness that is infinite";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("sphere 1 comes to 1e+30 m/s"), std::string::npos) << error.what();
  }
  Scene far = two_spheres(ContactLaw::spring, k, 1, 40);
  far.positions[1].z = -1e12f;
  choose_contacts(far, {.law = ContactLaw::spring});
  expect_refused(far, 1, "as far out as sphere 1, 1e+12 m along an axis");
}

}  // namespace
}  // namespace spherepair
