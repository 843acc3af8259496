// SPDX-License-Identifier: MIT
// What all walls together give a sphere is the sum of what each gives it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr int64_t radius_in_units = int64_t(1) << 40;

// A box so narrow along x that both walls touch a sphere in its middle.
ContactParams narrow_box(ContactLaw law, float damping) {
  ContactParams c = {};
  c.high_x = 3 * radius_in_units / 2, c.high_y = c.high_z = 8 * radius_in_units;
  c.law = uint(law), c.unit_exponent = 41, c.reach_exponent = -1;
  c.impulse = 0x1p50f, c.damping = damping, c.mobility = 0x1p-12f;
  return c;
}

Push sum_of_walls(const Body& s, const ContactParams& c) {
  const int64_t low[] = {push_of_wall(s.x - c.low_x, s.px, s.radius, c), push_of_wall(s.y - c.low_y, s.py, s.radius, c),
                         push_of_wall(s.z - c.low_z, s.pz, s.radius, c)};
  const int64_t high[] = {push_of_wall(c.high_x - s.x, -s.px, s.radius, c),
                          push_of_wall(c.high_y - s.y, -s.py, s.radius, c),
                          push_of_wall(c.high_z - s.z, -s.pz, s.radius, c)};
  bool behind = false;
  for (int axis = 0; axis < 3; ++axis) behind |= low[axis] < 0 || high[axis] < 0;
  return {low[0] - high[0], low[1] - high[1], low[2] - high[2], behind ? uint(FAULT_DEEP) : uint(FAULTS)};
}

TEST(ContactWalls, GiveTheSumOfWhatEachGives) {
  std::mt19937_64 random(12);
  const auto within = [&](int64_t low, int64_t high) { return low + int64_t(random() % uint64_t(high - low)); };
  uint64_t touched = 0, between_two = 0, behind = 0, away = 0;
  for (const ContactLaw law : {ContactLaw::spring, ContactLaw::hertz, ContactLaw::quartic})
    for (const float damping : {0.0f, law == ContactLaw::spring ? 0x1p40f : 0.0f})
      for (int k = 0; k < 20000; ++k) {
        const ContactParams c = narrow_box(law, damping);
        const auto momentum = [&] { return within(-int64_t(1) << 50, int64_t(1) << 50); };
        const int64_t margin = k % 10 ? 0 : radius_in_units / 8;  // of the centres that are behind walls
        const auto coordinate = [&](int64_t high) { return within(-margin, high + margin); };
        const Body s = {
            coordinate(c.high_x), coordinate(c.high_y), coordinate(c.high_z), momentum(), momentum(), momentum(), 0.5f};
        const Push each = sum_of_walls(s, c);
        SCOPED_TRACE(fmt::format("{} at {} {} {}", contact_name(law), s.x, s.y, s.z));
        for (const bool tests_all : {false, true}) {
          const Push all = push_of_walls(s, tests_all, c);
          ASSERT_EQ(all.x, each.x);
          ASSERT_EQ(all.y, each.y);
          ASSERT_EQ(all.z, each.z);
          ASSERT_EQ(all.fault, each.fault);
        }
        touched += each.y != 0 || each.z != 0;
        between_two += s.x < radius_in_units && c.high_x - s.x < radius_in_units;
        behind += each.fault == FAULT_DEEP;
        away += (walls_near(s, c) & ~9u) == 0;
      }
  EXPECT_GT(touched, 10000);
  EXPECT_GT(between_two, 10000);
  EXPECT_GT(behind, 1000);
  EXPECT_GT(away, 10000);
}

}  // namespace
}  // namespace spherepair
