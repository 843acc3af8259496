// SPDX-License-Identifier: MIT
// Contacts in periodic boxes: each step against all images of all spheres, and what a box without walls keeps.
#include <fmt/format.h>

#include <cmath>

#include "tests/contacts/periodic_gas.h"

namespace spherepair {
namespace {

class PeriodicContacts : public BackendTest {};
class PeriodicContactsInKernels : public KernelTest {};

struct Units {
  int64_t low[3], high[3];
  bool periodic[3];
};

Units units_of(const Scene& scene) {
  const ContactParams c = contact_params(scene);
  const uint axes = scene.contact.periodic;
  return {{c.low_x, c.low_y, c.low_z}, {c.high_x, c.high_y, c.high_z}, {(axes & 1) != 0, (axes & 2) != 0, axes > 3}};
}

// The same parameters in an open box, with walls where the box does not repeat: they know of no image.
ContactParams open_params(const Scene& scene) {
  ContactParams c = contact_params(scene);
  const Units units = units_of(scene);
  int64_t* const walls[3][2] = {{&c.low_x, &c.high_x}, {&c.low_y, &c.high_y}, {&c.low_z, &c.high_z}};
  for (int axis = 0; axis < 3; ++axis)
    if (units.periodic[axis]) *walls[axis][0] = -2 * MOST_UNITS, *walls[axis][1] = 2 * MOST_UNITS;
  c.box_low = c.box_high = {};
  return c;
}

// Steps in which each sphere is pushed by all images of all others.
std::vector<uint> after_all_images(const Scene& scene, uint64_t steps) {
  const ContactParams c = open_params(scene);
  const Units units = units_of(scene);
  const uint64_t n = scene.size();
  std::vector<uint> wide = fixed_state(scene);
  for (uint64_t step = 0; step < steps; ++step) {
    std::vector<Push> sums(n, Push{0, 0, 0, FAULTS});
    for (uint64_t i = 0; i < n; ++i)
      for (uint64_t j = 0; j < n; ++j)
        for (int image = 0; image < 27 && i != j; ++image) {
          Body b = load_body(wide, scene.positions, j);
          int64_t* const at[3] = {&b.x, &b.y, &b.z};
          const int shift[3] = {image / 9 - 1, image / 3 % 3 - 1, image % 3 - 1};
          bool repeats = true;
          for (int axis = 0; axis < 3; ++axis) {
            repeats = repeats && (shift[axis] == 0 || units.periodic[axis]);
            *at[axis] += shift[axis] * (units.high[axis] - units.low[axis]) * int(units.periodic[axis]);
          }
          if (!repeats) continue;
          const Push push = push_of_pair(load_body(wide, scene.positions, i), b, c);
          sums[i].x += push.x, sums[i].y += push.y, sums[i].z += push.z;
        }
    for (uint64_t i = 0; i < n; ++i) {
      const Body s = load_body(wide, scene.positions, i);
      const Body faster = kicked(s, sums[i], push_of_walls(s, false, c), c);
      const float mobility = mobility_of(s.radius, c);
      Body moved = drifted(faster, speeds_of(faster, mobility), mobility, c);
      int64_t* const at[3] = {&moved.x, &moved.y, &moved.z};
      for (int axis = 0; axis < 3; ++axis) {
        const int64_t period = units.high[axis] - units.low[axis];
        if (units.periodic[axis])
          *at[axis] = units.low[axis] + ((*at[axis] - units.low[axis]) % period + period) % period;
      }
      store_body(wide, n, i, moved);
    }
  }
  return wide;
}

TEST_P(PeriodicContactsInKernels, EachStepHasTheImpulsesOfAllImages) {
  for (const uint axes : AXES)
    for (const float from : {0.0f, -3000.0f}) {
      const ContactLaw law = axes == 7 ? ContactLaw::spring : axes == 1 ? ContactLaw::hertz : ContactLaw::quartic;
      const Scene scene = periodic_gas(
          axes, {.side = 4, .ratio = from == 0 ? 1.0f : 1.5f, .law = law, .from = from, .steps_a_contact = 12});
      const uint64_t steps = by_form(150, 100);
      EXPECT_EQ(run_steps(backend(), scene, steps).wide, after_all_images(scene, steps))
          << axes_text(axes) << ", " << from << " m from the origin";
      backend().check_guards();
    }
}

// With a damper, drag, gravity and walls beside the periodic axes; long enough for spheres to cross the box.
TEST_P(PeriodicContacts, SameBitsAsOnTheCpu) {
  for (const uint axes : {7u, 5u}) {
    Scene scene = periodic_gas(axes, {.ratio = 2, .gravity = axes == 7 ? 0 : -9.81f, .law = ContactLaw::spring});
    scene.restitution = 0.7f;
    scene.contact.drag = 0.01f;
    const Motion::State wanted = run_steps(cpu_backend(), scene, 1500);
    expect_equal_states(run_steps(backend(), scene, 1500), wanted, axes_text(axes));
    backend().check_guards();
  }
}

// A list serves many steps though spheres cross faces.
TEST_P(PeriodicContacts, NearPairsAreListedSeldom) {
  const Scene scene = periodic_gas(7, {.side = 4, .ratio = 4, .law = ContactLaw::spring, .steps_a_contact = 12});
  expect_near_pairs_listed_seldom(backend(), scene);
}

// A cloud spreads from the middle of its box, fastest along x. At first no sphere has an image, later more and more
// have one.
TEST_P(PeriodicContacts, ImagesGetRoomAsTheyBecomeMore) {
  Scene scene = gas({.side = 5, .law = ContactLaw::spring, .steps_a_contact = 12});
  const float middle = 2.625f;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const vec4& s = scene.positions[i];
    scene.velocities[i] = {0.6f * (s.x - middle), 0.4f * (s.y - middle), 0.2f * (s.z - middle), 0};
  }
  choose_contacts(scene, {.law = ContactLaw::spring,
                          .stiffness = scene.contact.stiffness,
                          .dt = scene.dt,
                          .box = WallBox{{-1, -1, -1}, {6.25f, 6.25f, 6.25f}, 7}});
  ASSERT_EQ(why_no_contacts(scene), "");
  cpu_backend().upload(scene);
  uint64_t steps = 0, pairs = 0;
  for (; pairs < 40 && steps < 8000; ++steps) {
    cpu_backend().move();
    if (steps % 50 == 0) cpu_backend().collide({}), pairs = cpu_backend().collisions().pairs;
  }
  EXPECT_GE(pairs, 40u) << "across faces";
  expect_equal_states(run_steps(backend(), scene, steps + 100), run_steps(cpu_backend(), scene, steps + 100), "spread");
}

// Half a box is a whole number of units: a gas moved by it, and back into the box, moves alike.
TEST_P(PeriodicContacts, AMovedGasMovesAlike) {
  const float length = 8;
  const WallBox box{{0, 0, 0}, {length, length, length}, 7};
  Scene scene = gas({.side = 6, .law = ContactLaw::spring});
  choose_contacts(scene, {.law = ContactLaw::spring, .stiffness = scene.contact.stiffness, .dt = scene.dt, .box = box});
  for (vec4& s : scene.positions)
    for (float vec4::*axis : {&vec4::x, &vec4::y, &vec4::z}) s.*axis = std::round(s.*axis * 0x1p16f) * 0x1p-16f;
  Scene moved = scene;
  for (vec4& s : moved.positions) s.x = std::fmod(s.x + length / 2, length), s.z = std::fmod(s.z + length / 2, length);
  const std::vector<uint> here = run_steps(backend(), scene, 400).wide, there = run_steps(backend(), moved, 400).wide;
  const int64_t period = contact_params(scene).high_x, n = int64_t(scene.size());
  for (int64_t k = 0; k < 6 * n; ++k) {
    const bool moves = k < n || (k >= 2 * n && k < 3 * n);
    ASSERT_EQ(moves ? (word(here, uint64_t(k)) + period / 2) % period : word(here, uint64_t(k)),
              word(there, uint64_t(k)))
        << k;
  }
}

TEST_P(PeriodicContacts, MomentumIsKeptToTheBitWithoutWalls) {
  const Scene scene = periodic_gas(7, {.ratio = 1.5f, .law = ContactLaw::hertz});
  const std::vector<uint> before = fixed_state(scene), after = run_steps(backend(), scene, 300).wide;
  const uint64_t n = scene.size();
  for (uint64_t axis = 3; axis < 6; ++axis) {
    int64_t sums[2] = {0, 0};
    for (uint64_t i = 0; i < n; ++i) sums[0] += word(before, axis * n + i), sums[1] += word(after, axis * n + i);
    EXPECT_EQ(sums[0], sums[1]) << axis;
  }
}

TEST_P(PeriodicContacts, TheWayBackLeadsToTheFirstBits) {
  const Scene scene = periodic_gas(7, {.ratio = 1.5f, .law = ContactLaw::quartic});
  const uint64_t n = scene.size();
  const std::vector<uint> start = run_steps(backend(), scene, 0).wide,
                          back = there_and_back(backend(), scene, 200, false);
  for (uint64_t k = 0; k < 3 * n; ++k) ASSERT_EQ(word(back, k), word(start, k)) << k;
}

INSTANTIATE_BACKENDS(PeriodicContacts);
INSTANTIATE_BACKENDS(PeriodicContactsInKernels);

}  // namespace
}  // namespace spherepair
