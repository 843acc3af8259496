// SPDX-License-Identifier: MIT
// The shared predicate compiled for the CPU, called directly: the same adversarial pairs, flushed denormals, the parts
// of the filter by themselves, and symmetries.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <cmath>

#include "tests/oracle/oracle.h"
#include "tests/oracle/tally.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

// The tests of the backends decide all of them.
uint64_t some_of(const FamilyPairs& plan) {
  return std::min<uint64_t>(plan.pairs, full_stress() ? plan.pairs : 400'000);
}

TEST(Predicate, RightOnEveryFamily) {
  for (const FamilyPairs& plan : PLANS) {
    const Tally result = tally(plan.family, some_of(plan), decide_directly);
    EXPECT_EQ(result.wrong, 0u) << "family " << int(plan.family) << ": " << result.first_wrong;
  }
}

#if defined(__SSE2__)
// Row 5 again: denormal inputs read as zero and denormal results flushed, as a GPU may do.
TEST(Predicate, RightWhenDenormalsAreFlushed) {
  const Decider flushed = [](std::span<const vec4> spheres) {
    constexpr uint flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    const uint control = _mm_getcsr();
    std::vector<uint> verdicts(spheres.size() / 2);
    _mm_setcsr(control | flush_to_zero | denormals_are_zero);
    for (size_t k = 0; k < verdicts.size(); ++k)
      verdicts[k] = verdict_code(decide_pair(spheres[2 * k], spheres[2 * k + 1], bits_float(FILTER_SCALE_BITS),
                                             bits_float(FILTER_OFFSET_BITS)));
    _mm_setcsr(control);
    return verdicts;
  };
  for (const FamilyPairs& plan : PLANS) {
    const Tally result = tally(plan.family, some_of(plan), flushed);
    EXPECT_EQ(result.wrong, 0u) << "family " << int(plan.family) << ": " << result.first_wrong;
  }
}
#endif

// The coarse Gram test may pass too much, but a pair that it rejects must not collide.
TEST(Predicate, GramFormRejectsNoCollision) {
  uint64_t rejected = 0, pairs = 0;
  for (const FamilyPairs& plan : PLANS) {
    std::vector<vec4> spheres = adversarial_pairs(plan.family, 0, some_of(plan));
    for (vec4& sphere : spheres) sphere.w = std::abs(sphere.w);
    const std::vector<Relation> truths = relations(spheres);
    for (size_t k = 0; k < truths.size(); ++k, ++pairs) {
      const vec4 a = spheres[2 * k], b = spheres[2 * k + 1];
      const vec4 origin = k % 3 == 0 ? vec4{0, 0, 0, 0} : k % 3 == 1 ? a : vec4{b.x + 3, b.y, b.z - 5, 0};
      const vec4 left = gram_form(a, origin, 0.5f), right = gram_form(b, origin, 0.5f);
      const float product = multiply_add(a.w, b.w, gram_product(left.x, left.y, left.z, -left.w, right));
      if (!(product < right.w)) continue;
      ++rejected;
      ASSERT_NE(truths[k], Relation::overlapping) << "family " << int(plan.family) << ", " << show_pair(a, b);
    }
  }
  EXPECT_GT(rejected, pairs / 100);
}

// share: both radii in one form, where the bits are compared as integers; or one in each.
void expect_equal_radii_kept(float row_share, float column_share) {
  uint64_t rejected = 0;
  for (Family family : {Family::random_bits, Family::near_tangent, Family::extreme, Family::denormal}) {
    std::vector<vec4> spheres = adversarial_pairs(family, 0, 200'000);
    for (size_t k = 0; k < spheres.size() / 2; ++k) {
      vec4 &a = spheres[2 * k], &b = spheres[2 * k + 1];
      a.w = b.w = (std::abs(a.w) * 0.5f + std::abs(b.w) * 0.5f) * (k % 2 == 0 ? 1.0f : 0.5f);
      const vec4 origin = k % 3 == 0 ? vec4{0, 0, 0, 0} : k % 3 == 1 ? a : b;
      const vec4 row = gram_form(a, origin, row_share), column = gram_form(b, origin, column_share);
      const float product = gram_product(row.x, row.y, row.z, -row.w, column);
      const bool apart = column_share == 0 ? signed_bits(product) < signed_bits(column.w) : product < column.w;
      if (!apart) continue;
      ++rejected;
      ASSERT_NE(relation(a, b), Relation::overlapping) << "family " << int(family) << ", " << show_pair(a, b);
    }
  }
  EXPECT_GT(rejected, 0u);
}

TEST(Predicate, GramFormOfEqualRadiiRejectsNoCollision) { expect_equal_radii_kept(1, 1); }
TEST(Predicate, GramFormOfEqualRadiiComparedAsIntegersRejectsNoCollision) { expect_equal_radii_kept(2, 0); }

// One sphere within the range of the forms and one beyond it: a square of 2^100 or more is no form.
TEST(Predicate, WhatIsBeyondTheGramFormStaysACandidate) {
  const vec4 within = {0x1.fp49f, 0, 0, 0x1p48f}, beyond = {0x1.1p50f, 0, 0, 0x1p48f}, origin = {0, 0, 0, 0};
  ASSERT_EQ(relation(within, beyond), Relation::overlapping);
  const auto is_candidate = [&](vec4 a, vec4 b) {
    const vec4 row = gram_form(a, origin, 2), column = gram_form(b, origin, 0);
    return signed_bits(gram_product(row.x, row.y, row.z, -row.w, column)) >= signed_bits(column.w);
  };
  EXPECT_TRUE(is_candidate(within, beyond));
  EXPECT_TRUE(is_candidate(beyond, within));
}

// Spheres whose inputs are small integers times 1/8: ties are common, and scaled or mirrored they stay exact.
rc::Gen<vec4> any_sphere() {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-24, 25), [](int k) { return float(k) / 8; });
  const auto radius = rc::gen::map(rc::gen::inRange(0, 25), [](int k) { return float(k) / 8; });
  return rc::gen::apply(
      [](float x, float y, float z, float r) {
        return vec4{x, y, z, r};
      },
      coordinate, coordinate, coordinate, radius);
}

bool collide(vec4 a, vec4 b) {
  return decide_pair(a, b, bits_float(FILTER_SCALE_BITS), bits_float(FILTER_OFFSET_BITS)).collide;
}

void check_property(const char* name, const std::function<bool(vec4, vec4, int)>& same) {
  EXPECT_TRUE(rc::check(name, [&] {
    const vec4 a = *any_sphere(), b = *any_sphere();
    const int parameter = *rc::gen::inRange(-140, 120);
    RC_CLASSIFY(relation(a, b) == Relation::tangent, "tangent");
    RC_ASSERT(same(a, b, parameter));
  }));
}

TEST(Predicate, Symmetric) {
  check_property("a hits b as b hits a", [](vec4 a, vec4 b, int) { return collide(a, b) == collide(b, a); });
}

TEST(Predicate, ScalesByPowersOfTwo) {
  check_property("unchanged by a power of two", [](vec4 a, vec4 b, int k) {
    const auto scaled = [k](vec4 s) {
      return vec4{std::ldexp(s.x, k), std::ldexp(s.y, k), std::ldexp(s.z, k), std::ldexp(s.w, k)};
    };
    return collide(a, b) == collide(scaled(a), scaled(b));
  });
}

TEST(Predicate, UnchangedByPermutedAxes) {
  check_property("unchanged by permuted axes", [](vec4 a, vec4 b, int) {
    const bool answer = collide(a, b);
    return answer == collide({a.y, a.z, a.x, a.w}, {b.y, b.z, b.x, b.w}) &&
           answer == collide({a.y, a.x, a.z, a.w}, {b.y, b.x, b.z, b.w});
  });
}

TEST(Predicate, UnchangedByMirrors) {
  check_property("unchanged by mirrors", [](vec4 a, vec4 b, int k) {
    const float x = k & 1 ? -1.0f : 1.0f, y = k & 2 ? -1.0f : 1.0f, z = k & 4 ? -1.0f : 1.0f;
    return collide(a, b) == collide({a.x * x, a.y * y, a.z * z, a.w}, {b.x * x, b.y * y, b.z * z, b.w});
  });
}

TEST(Predicate, LargerRadiusStillCollides) {
  check_property("monotonic in the radius", [](vec4 a, vec4 b, int) {
    return !collide(a, b) || collide(a, {b.x, b.y, b.z, nudged(b.w, 1)});
  });
}

}  // namespace
}  // namespace spherepair
