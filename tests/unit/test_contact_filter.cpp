// SPDX-License-Identifier: MIT
// The float32 test that passes over near pairs, against the exact test of the same spheres in integers.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"

namespace spherepair {
namespace {

constexpr float OFFSETS[] = {0, 3'000, 100'000};

ContactParams params_at(float offset, float ratio) {
  Scene scene = {.name = "two", .equal_radii = false};
  scene.positions = {{offset, offset, offset, 0.25f}, {offset + 3 * ratio, offset, offset, 0.5f * ratio}};
  scene.velocities.resize(2);
  choose_contacts(scene, {.law = ContactLaw::spring});
  EXPECT_EQ(why_no_contacts(scene), "");
  return contact_params(scene);
}

struct Direction {
  double x, y, z;
};

// Each axis in both directions for k < 6, then at random.
Direction direction_of(int k, std::mt19937_64& random) {
  const double sign = k % 2 == 0 ? 1 : -1;
  if (k < 6) return {k / 2 == 0 ? sign : 0, k / 2 == 1 ? sign : 0, k / 2 == 2 ? sign : 0};
  std::normal_distribution<double> any;
  const double x = any(random), y = any(random), z = any(random), length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

// Two spheres on opposite sides of a point. For every third k the point is in their own direction from the origin, just
// beyond a power of two, where centres are rounded most for their distance; else about `offset` away along each axis.
struct TwoSpheres {
  ContactParams c;
  Direction d;
  int64_t x, y, z;
  float ra, rb;

  TwoSpheres(const ContactParams& params, float offset, float ratio, int k, std::mt19937_64& random) : c(params) {
    std::uniform_real_distribution<float> share(0.5f, 1);
    d = direction_of(k % 40, random);
    const auto units = [&](double at) { return std::llrint(std::ldexp(at, c.unit_exponent)); };
    const auto out = [&] { return units((random() % 4 == 0 ? -1 : 1) * double(share(random) * (offset + 1))); };
    const double from = std::bit_floor(uint(offset)) * (1 + 0.01 * double(share(random)));
    x = units(d.x * from), y = units(d.y * from), z = units(d.z * from);
    if (k % 3 != 0) x = out(), y = out(), z = out();
    ra = 0.5f * share(random) * (k % 2 == 0 ? 1 : ratio), rb = 0.5f * share(random) * (k % 5 < 3 ? ratio : 1);
  }
  double reach() const { return std::ldexp(double(ra + rb), c.unit_exponent); }
  Body first(int64_t apart) const {
    const auto half = [&](double along) { return std::llrint(along * double(apart)) / 2; };
    return {x - half(d.x), y - half(d.y), z - half(d.z), 0, 0, 0, ra};
  }
  Body second(int64_t apart) const {
    const Body a = first(apart);
    const auto whole = [&](double along) { return std::llrint(along * double(apart)); };
    return {a.x + whole(d.x), a.y + whole(d.y), a.z + whole(d.z), 0, 0, 0, rb};
  }
  bool are_in_contact(int64_t apart) const { return in_contact(gap_between(first(apart), second(apart), c)); }
  bool passed_over(int64_t apart) const { return is_apart(centre_of(first(apart), c), centre_of(second(apart), c), c); }
  int64_t last_contact() const {
    int64_t within = std::llrint(0.999 * reach()), beyond = std::llrint(1.001 * reach());
    EXPECT_TRUE(are_in_contact(within) && !are_in_contact(beyond));
    while (beyond - within > 1) (are_in_contact((within + beyond) / 2) ? within : beyond) = (within + beyond) / 2;
    return within;
  }
};

template <typename Check>
void for_all(int count, const Check& check) {
  std::mt19937_64 random(66);
  for (const float offset : OFFSETS)
    for (const float ratio : {1.0f, 8.0f}) {
      const ContactParams c = params_at(offset, ratio);
      for (int k = 0; k < count; ++k) check(TwoSpheres(c, offset, ratio, k, random), offset);
    }
}

TEST(ContactFilter, NoContactIsPassedOver) {
  for_all(50'000, [](const TwoSpheres& two, float offset) {
    const int64_t last = two.last_contact();
    for (const int64_t apart : {last, last - 1, last - last % 64}) {
      if (!two.are_in_contact(apart)) continue;
      ASSERT_FALSE(two.passed_over(apart))
          << offset << ": " << two.ra << " and " << two.rb << ", " << two.d.x << ' ' << two.d.y << ' ' << two.d.z;
    }
  });
}

TEST(ContactFilter, WhatIsApartByHalfOfItsSkinsIsPassedOver) {
  for_all(2'000, [](const TwoSpheres& two, float offset) {
    ASSERT_TRUE(two.passed_over(std::llrint(two.reach() * (1 + 0.5 * double(two.c.skin))))) << offset;
  });
}

// As far from it as the spheres are large, float32 is no coarser than the filter's own arithmetic.
TEST(ContactFilter, NearTheOriginWhatIsApartByAHundredThousandthIsPassedOver) {
  for_all(2'000, [](const TwoSpheres& two, float offset) {
    if (offset > 0) return;
    ASSERT_TRUE(two.passed_over(std::llrint(two.reach() * (1 + 1e-5))));
  });
}

// Two spheres in a periodic box, across its faces, edges and corners: `first` is inside, `second` beside it and then
// wrapped into the box.
struct AcrossFaces {
  ContactParams c;
  std::mt19937_64& random;

  double any() const { return std::uniform_real_distribution<double>(-1, 1)(random); }
  Body inside(Body s) const { return wrapped(s, c); }
  int64_t units(double at) const { return std::llrint(std::ldexp(at, c.unit_exponent)); }
  Body first(float radius) const {  // near two faces of three, on either side
    const int64_t x = any() < 0 ? c.low_x : c.high_x - 1, z = any() < 0 ? c.low_z : c.high_z - 1;
    return inside(
        {x + units(0.4 * any()), any() < 0 ? c.low_y : c.high_y - 1, z + units(0.4 * any()), 0, 0, 0, radius});
  }
  Body beside(Body s, double apart, float radius) const {
    const Direction d = direction_of(6, random);
    const auto along = [&](double part) { return units(part * apart * (double(s.radius) + double(radius))); };
    s.x += along(d.x), s.y += along(d.y), s.z += along(d.z), s.radius = radius;
    return inside(s);
  }
};

ContactParams params_of_box(float from, float length) {
  Scene scene = {.name = "two", .gravity = 0, .equal_radii = false};
  scene.positions = {{from + 1, from + 1, from + 1, 0.25f}, {from + 2, from + 2, from + 2, 0.5f}};
  scene.velocities.resize(2);
  const float to = from + length;
  choose_contacts(scene, {.law = ContactLaw::spring, .box = WallBox{{from, from, from}, {to, to, to}, 7}});
  EXPECT_EQ(why_no_contacts(scene), "");
  return contact_params(scene);
}

// Whether the search that lists near pairs sees these two collide: each other, or one and an image of the other.
bool are_listed(const Body& a, const Body& b, const ContactParams& c) {
  const vec4 grown[2] = {grown_sphere(centre_of(a, c), c), grown_sphere(centre_of(b, c), c)};
  const auto collide = [](const vec4& p, const vec4& q) {
    const double x = double(p.x) - double(q.x), y = double(p.y) - double(q.y), z = double(p.z) - double(q.z);
    return x * x + y * y + z * z < std::pow(double(p.w) + double(q.w), 2);
  };
  int found = collide(grown[0], grown[1]);
  for (int k = 0; k < 2; ++k)
    for (uint image = FIRST_IMAGE; image < END_OF_IMAGES; ++image)
      if (image_is_needed(image, image_faces(grown[k], c)))
        found += collide(grown[1 - k], sphere_of_image(k == 0 ? a : b, image, grown[k].w, c));
  EXPECT_LE(found, 1) << "the same pair twice";
  return found == 1;
}

TEST(ContactFilter, NoContactAcrossFacesIsLost) {
  std::mt19937_64 random(7);
  for (const float from : {0.0f, -3.0f, 3'000.0f})
    for (const float length : {4.25f, 9.1f}) {
      const AcrossFaces box{params_of_box(from, length), random};
      const ContactParams& c = box.c;
      uint64_t contacts = 0, across = 0;
      for (int k = 0; k < 60'000; ++k) {
        const float radii[2] = {k % 3 == 0 ? 0.5f : 0.3f, 0.5f};
        const Body a = box.first(radii[0]), b = box.beside(a, 1.1 * std::abs(box.any()), radii[1]);
        const bool touch = in_contact(gap_between(a, b, c));
        const Ways way = ways_between(a, b, c);
        across += touch && (way.x != a.x - b.x || way.y != a.y - b.y || way.z != a.z - b.z);
        contacts += touch;
        if (touch) {
          ASSERT_FALSE(is_apart(centre_of(a, c), centre_of(b, c), c)) << from << ' ' << length;
        }
        // Where they were when pairs were listed, if neither has left its skin since.
        const auto earlier = [&](const Body& s) { return box.beside(s, 0.04 * std::abs(box.any()), s.radius); };
        const Body then[2] = {earlier(a), earlier(b)};
        const auto left = [&](const Body& now, const Body& before) {
          return has_left_skin(centre_of(now, c), grown_sphere(centre_of(before, c), c), c);
        };
        if (!touch || left(a, then[0]) || left(b, then[1])) continue;
        ASSERT_TRUE(are_listed(then[0], then[1], c)) << from << ' ' << length;
      }
      EXPECT_GT(across, contacts / 4);
      EXPECT_GT(contacts, 20'000u);
    }
}

}  // namespace
}  // namespace spherepair
