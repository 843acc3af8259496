// SPDX-License-Identifier: MIT
// Sums of impulses stay within 64 bits: the bound that is checked before the start, against heaps of spheres pressed
// together as far as a step allows, and against the scenes that it refuses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr ContactLaw LAWS[] = {ContactLaw::spring, ContactLaw::quartic, ContactLaw::hertz};

Scene two_spheres(ContactLaw law, float ratio, float restitution, double steps_a_contact = 40, float stiffer = 1,
                  float speed = 1) {
  Scene scene = {.name = "two", .restitution = restitution, .equal_radii = ratio == 1};
  scene.positions = {{-2 * ratio, 0, 0, 0.5f}, {2 * ratio, 0, 0, 0.5f * ratio}};
  scene.velocities = {{speed, 0, 0, 0}, {-speed, 0, 0, 0}};
  choose_contacts(scene, {.law = law});
  choose_contacts(scene, {.law = law, .stiffness = scene.contact.stiffness * stiffer});
  const float dt = float(contact_time(scene) / steps_a_contact);
  choose_contacts(scene, {.law = law, .stiffness = scene.contact.stiffness, .dt = dt});
  return scene;
}

double bound_of(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  return std::ldexp(greatest_impulse_sum({contact.law,
                                          double(contact.stiffness),
                                          double(scene.restitution),
                                          double(scene.gravity),
                                          double(scene.dt),
                                          {scene.positions[0].w, scene.positions[1].w}}),
                    contact.momentum_exponent);
}

// With the greatest momentum of a step just below a power of two, of which units are shares.
Scene at_a_power_of_two(ContactLaw law, float ratio, float restitution) {
  const float speed = 256 * ratio;  // so fast that a fall is nothing to it
  const Scene scene = two_spheres(law, ratio, restitution, 40, 1, speed);
  const double momentum = sphere_mass(double(scene.positions[1].w)) * 0.5 / double(scene.dt);
  const double octave = std::exp2(std::ceil(std::log2(momentum)));
  return two_spheres(law, ratio, restitution, 40, 1, speed * float(octave / momentum * (1 - 1e-5)));
}

struct Heap {
  const ContactParams c;
  std::vector<Body> bodies;  // the first is that which the others press

  // The others' radii from this one up to the largest, placed where no overlap is deeper than the smaller radius, and
  // all as fast towards the first as a step allows.
  Heap(const Scene& scene, float from, int tries, std::mt19937& random) : c(contact_params(scene)) {
    const float largest = scene.positions[1].w;
    std::uniform_real_distribution<double> any(-1, 1), share(0, 1);
    std::vector<vec4> at = {{0, 0, 0, largest}};
    for (int k = 0; k < tries; ++k) {
      const double x = any(random), y = any(random), z = any(random), length = std::hypot(x, y, z);
      const float radius = std::min(from * float(std::exp2(share(random))), largest);
      const double d = (1.001 * double(largest) + 0.3 * share(random) * double(radius)) / length;
      const vec4 sphere = {float(x * d), float(y * d), float(z * d), radius};
      const auto clear = [&](const vec4& other) {
        const double apart = std::hypot(double(other.x) - x * d, double(other.y) - y * d, double(other.z) - z * d);
        return apart > 1.001 * double(std::max(other.w, radius));
      };
      if (length > 0.1 && std::ranges::all_of(at, clear)) at.push_back(sphere);
    }
    const auto units = [&](float x) { return integer_of(std::ldexp(x, c.unit_exponent)); };
    for (const vec4& s : at) {
      const float most = 0.999f * c.fastest / mobility_of(s.w, c);
      const auto inwards = [&](float x) { return integer_of(x == 0 ? 0 : std::copysign(most, -x)); };
      bodies.push_back({units(s.x), units(s.y), units(s.z), inwards(s.x), inwards(s.y), inwards(s.z), s.w});
    }
  }
  double pushes() const {  // whatever their signs, along the axis that has most
    double sums[3] = {};
    for (size_t k = 1; k < bodies.size(); ++k) {
      const Push push = push_of_pair(bodies[0], bodies[k], c);
      EXPECT_EQ(push.fault, FAULTS);
      sums[0] += std::abs(double(push.x)), sums[1] += std::abs(double(push.y)), sums[2] += std::abs(double(push.z));
    }
    return std::max({sums[0], sums[1], sums[2]});
  }
};

// Spheres that are thrown in at random leave gaps: the bound is within a factor of 1000 of what they do.
TEST(ContactBounds, NoHeapOfSpheresPushesMoreThanTheBound) {
  std::mt19937 random(63);
  for (const ContactLaw law : LAWS)
    for (const float ratio : {1.0f, 3.0f, 16.0f})
      for (const float restitution : {1.0f, 0.3f}) {
        if (restitution < 1 && law != ContactLaw::spring) continue;
        const Scene scene = two_spheres(law, ratio, restitution);
        double most = 0;
        for (float from = 0.5f; from <= 0.5f * ratio; from *= 2) {
          const Heap heap(scene, from, 20'000, random);
          ASSERT_GT(heap.bodies.size(), 8u);
          most = std::max(most, heap.pushes());
        }
        const double momentum = std::ldexp(sphere_mass(double(scene.positions[1].w)) * 0.5 / double(scene.dt),
                                           scene.contact.momentum_exponent);
        const double pushes = bound_of(scene) - momentum;
        EXPECT_LT(most, pushes) << contact_name(law) << " 1:" << ratio << ' ' << restitution;
        EXPECT_GT(most, pushes / 1000) << contact_name(law) << " 1:" << ratio << ' ' << restitution;
      }
}

TEST(ContactBounds, EveryLawsOwnTimeStepHolds) {
  for (const ContactLaw law : LAWS)
    for (const float ratio : {1.0f, 2.0f, 2.001f, 2.01f, 3.0f, 8.0f, 64.0f, 256.0f})
      for (const float restitution : {1.0f, 0.5f, 0.1f})
        if (restitution == 1 || law == ContactLaw::spring) {
          const Scene highest = at_a_power_of_two(law, ratio, restitution);
          EXPECT_LT(bound_of(highest), 0.58 * 0x1p63) << contact_name(law) << " 1:" << ratio;
          for (const Scene& scene : {highest, two_spheres(law, ratio, restitution)})
            EXPECT_EQ(why_no_contacts(scene), "") << contact_name(law) << " 1:" << ratio;
        }
  EXPECT_GT(bound_of(at_a_power_of_two(ContactLaw::spring, 2.001f, 0.1354f)), 0.56 * 0x1p63);
}

// By a coarse step and a strong damper, or unequal spheres, or a stiffness for which contacts of slow spheres last
// long.
TEST(ContactBounds, WhatCouldAddUpBeyond64BitsIsRefusedWithAStepThatIsNot) {
  for (Scene scene : {two_spheres(ContactLaw::spring, 2, 0.1f, 6), two_spheres(ContactLaw::hertz, 2, 1, 3),
                      two_spheres(ContactLaw::hertz, 1, 1, 8, 1e6f)}) {
    const std::string why = why_no_contacts(scene), option = "could add up, but 64-bit integers hold 9.08e+18: give ";
    const size_t at = why.find(option);
    ASSERT_NE(at, std::string::npos) << contact_name(scene.contact.law) << ": " << why;
    const float dt = std::stof(why.substr(at + option.size() + std::string("--dt ").size()));
    EXPECT_GT(dt, scene.dt / 100);
    choose_contacts(scene, {.law = scene.contact.law, .stiffness = scene.contact.stiffness, .dt = dt});
    EXPECT_EQ(why_no_contacts(scene), "") << contact_name(scene.contact.law);
  }
}

}  // namespace
}  // namespace spherepair
