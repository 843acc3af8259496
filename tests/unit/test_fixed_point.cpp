// SPDX-License-Identifier: MIT
// The conversions of fixed-point state.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/shared/contact/contact.h"

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

}  // namespace
}  // namespace spherepair
