// SPDX-License-Identifier: MIT
// Two spheres, and one and the plane, against what is known of them exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"
#include "tests/support/soft_contacts.h"

namespace spherepair {
namespace {

constexpr double contact_seconds = 0x1p-6, mass = 1000 * 4 * std::numbers::pi / 3 / 8;

// Two spheres of radius 0.5, or one and the plane, a contact's time before they touch, at 1 m/s to each other.
struct Approach {
  ContactLaw law = ContactLaw::spring;
  double stiffness = std::pow(std::numbers::pi / contact_seconds, 2);  // over the reduced mass
  double restitution = 1;
  int steps_a_contact = 40;
  bool plane = false;
  double late = 0;  // in steps
};

Scene approaching(const Approach& a) {
  const double dt = contact_seconds / a.steps_a_contact;
  const float gap = float(contact_seconds + a.late * dt), half = 0.5f + gap / 2;
  Scene scene = {
      .name = "approach", .plane = a.plane ? 0.0f : -4.0f, .gravity = 0, .restitution = float(a.restitution)};
  if (a.plane)
    scene.positions = {{0, 0.5f + gap, 0, 0.5f}}, scene.velocities = {{0, -1, 0, 0}};
  else
    scene.positions = {{0, half, 0, 0.5f}, {0, -half, 0, 0.5f}}, scene.velocities = {{0, -0.5f, 0, 0}, {0, 0.5f, 0, 0}};
  const double stiffness = a.stiffness * (a.plane ? mass : mass / 2);
  choose_contacts(scene, {.law = a.law, .stiffness = float(stiffness), .dt = float(dt)});
  return scene;
}

// The overlap is that of a parabola through the deepest three, the time that between the straight paths to and fro.
struct Bounce {
  double overlap, seconds, speed;  // speed: over that before
};
Bounce bounce_of(const Approach& approach) {
  const Scene scene = approaching(approach);
  const uint64_t n = scene.size();
  const auto gap = [&] {
    const std::vector<uint> wide = current_state(cpu_backend()).wide;
    const int64_t apart = load_real<int64_t>(wide, n) - (approach.plane ? 0 : load_real<int64_t>(wide, n + 1));
    return std::ldexp(double(apart), -scene.contact.unit_exponent) - 0.5 * double(n);
  };
  cpu_backend().upload(scene);
  std::vector<double> gaps = {gap()};
  for (int step = 0; step < 4 * approach.steps_a_contact; ++step) cpu_backend().move(), gaps.push_back(gap());
  const auto deepest = std::ranges::min_element(gaps);
  const double slope = (deepest[1] - deepest[-1]) / 2, bend = deepest[1] - 2 * deepest[0] + deepest[-1];
  const double dt = double(scene.dt), before = (gaps[0] - gaps[1]) / dt, after = (gaps.back() - gaps.end()[-2]) / dt;
  const double seconds = double(gaps.size() - 1) * dt - gaps.back() / after - gaps[0] / before;
  return {slope * slope / (2 * bend) - *deepest, seconds, after / before};
}

// By Simpson's rule over the angle whose sine is R^2 - d^2 over its greatest.
double quartic_seconds(double reach, double greatest) {
  constexpr int parts = 1000;
  double sum = 0;
  for (int k = 0; k <= parts; ++k) {
    const double angle = std::numbers::pi / 2 * k / parts, weight = k % parts == 0 ? 1 : k % 2 == 0 ? 2 : 4;
    sum += weight / std::sqrt(reach * reach - greatest * std::sin(angle));
  }
  return greatest * sum * std::numbers::pi / 2 / (3 * parts);
}

void expect_bounces(Approach approach, double overlap, double seconds) {
  SCOPED_TRACE(fmt::format("{}, {}", contact_name(approach.law), approach.plane ? "plane" : "two spheres"));
  double last[2] = {};
  for (const int steps : {20, 40, 80, 160}) {
    approach.steps_a_contact = steps;
    const Bounce found = bounce_of(approach);
    const double errors[2] = {std::abs(found.overlap / overlap - 1), std::abs(found.seconds / seconds - 1)};
    for (int k = 0; k < 2; ++k) {
      EXPECT_LT(errors[k], 1.6 / (steps * steps)) << (k ? "time" : "overlap") << ", " << steps << " steps";
      if (steps > 20) {
        EXPECT_NEAR(last[k] / errors[k], 4, 0.25) << (k ? "time" : "overlap") << ", " << steps << " steps";
      }
      last[k] = errors[k];
    }
    EXPECT_NEAR(found.speed, 1, 1.6 / (steps * steps)) << steps << " steps";
  }
}

// 0.1 % at 40 steps a contact.
TEST(ContactLaws, BouncesFollowTheClosedFormAndErrorsFallWithTheSquareOfTheStep) {
  const double spring = contact_seconds / std::numbers::pi;
  const double hertz = contact_seconds * 5 * std::tgamma(0.9) / (4 * std::sqrt(std::numbers::pi) * std::tgamma(0.4));
  for (const bool plane : {false, true}) {
    const double reach = plane ? 0.5 : 1, depth = 2 * reach * spring;
    expect_bounces({.plane = plane}, spring, contact_seconds);
    expect_bounces({.law = ContactLaw::hertz, .stiffness = 1.25 / std::pow(hertz, 2.5), .plane = plane}, hertz,
                   contact_seconds);
    expect_bounces({.law = ContactLaw::quartic, .stiffness = 2 / (depth * depth), .plane = plane},
                   reach - std::sqrt(reach * reach - depth), quartic_seconds(reach, depth));
  }
}

// The damper's force begins with a jump: a bounce's own error depends on where in a step it begins, and is of first
// order.
TEST(ContactLaws, SpringLeavesTheRestitutionOfTheSpeedInTheMeanOfAStep) {
  constexpr int starts = 32;
  for (const bool plane : {false, true})
    for (const double restitution : {0.9, 0.7, 0.5}) {
      SCOPED_TRACE(fmt::format("{}, {}", restitution, plane ? "plane" : "two spheres"));
      double last = 0;
      for (const int steps : {20, 40, 80, 160}) {
        Approach approach = {.restitution = restitution, .steps_a_contact = steps, .plane = plane};
        double mean = 0;
        for (int start = 0; start < starts; ++start) {
          approach.late = (start + 0.5) / starts;
          const double error = bounce_of(approach).speed / restitution - 1;
          EXPECT_LT(std::abs(error), 2 * (1 - restitution) / steps) << steps << " steps";
          mean += error / starts;
        }
        EXPECT_LT(std::abs(mean), 1.6 / (steps * steps)) << steps << " steps";
        if (last != 0) {
          EXPECT_NEAR(last / mean, 4, 0.25) << steps << " steps";
        }
        last = mean;
      }
    }
}

// Their radii's sixth power is no float.
TEST(ContactLaws, SpringDampsSmallSpheresToo) {
  Scene scene = make_scene({.name = "collide2", .n = 2, .radius = 1e-7f});
  scene.restitution = 0.5f;
  choose_contacts(scene, {.law = ContactLaw::spring});
  const Motion::State end = run_steps(cpu_backend(), scene, 400);
  EXPECT_NEAR(end.velocities[1].x - end.velocities[0].x, 1, 0.01);  // together, of 2 m/s
}

// More spheres and pairs than one thread takes.
TEST(ContactLaws, SameBitsWithAnyNumberOfThreadsSortedOrNot) {
  Scene scene = make_scene({.name = "gas", .n = 20'000});
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = 1e5f});
  const std::vector<uint> order = shuffled(scene.size());
  const Scene unsorted = in_order(scene, order);
  Motion::State wanted;
  for (const int threads : {1, 2, 7}) {
    const auto backend = open_backend("cpu", {.threads = threads});
    const Motion::State found = run_steps(*backend, scene, 60);
    if (threads == 1) wanted = found;
    expect_equal_states(found, wanted, fmt::format("{} threads", threads));
    EXPECT_GT(run_step(*backend, fast_method(*backend)).totals.pairs, 4096u);
    EXPECT_EQ(run_steps(*backend, unsorted, 60).wide, in_order(wanted.wide, order)) << threads << " threads";
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
    if (has_left_skin(centre[0], then[0], c) || has_left_skin(centre[1], then[1], c)) continue;
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
  expect_refused(approaching({.steps_a_contact = 1}), 1, "but a contact lasts 0.0156 s only");
  expect_refused(approaching({.law = ContactLaw::quartic, .restitution = 0.5}), 1, "the law quartic is elastic");
  Scene fast = approaching({});
  fast.velocities[1].y = -1000;
  expect_refused(fast, 1, "sphere 1 moves at 1000 m/s, but");
  Scene deep = approaching({});
  deep.positions[0].y = deep.positions[1].y + 0.25f;
  expect_refused(deep, 1, "sphere 0 is deeper in sphere 1 than the smaller radius, 0.75 m of 0.5 m");
  Scene falling = approaching({});
  falling.velocities = {{0, 20, 0, 0}, {0, -20, 0, 0}};
  falling.contact.unit_exponent = 59;
  expect_refused(falling, 20'000, "sphere 0 has left the range of float32 centres and 64-bit positions, at (0, 4");
  Scene beyond = approaching({});
  beyond.velocities[1].y = 1e30f;
  try {
    choose_contacts(beyond, {.law = ContactLaw::spring});
    ADD_FAILURE() << "a stiffness that is infinite";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("sphere 1 comes to 1e+30 m/s"), std::string::npos) << error.what();
  }
  Scene far = approaching({});
  far.positions[1].z = -1e12f;
  choose_contacts(far, {.law = ContactLaw::spring});
  expect_refused(far, 1, "as far out as sphere 1, 1e+12 m along an axis");
}

}  // namespace
}  // namespace spherepair
