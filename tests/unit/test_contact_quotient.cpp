// SPDX-License-Identifier: MIT
// Quotients and roots that a guess and its remainder give, against those made bit by bit; and from guesses as bad as
// any machine's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "common/shared/contact/contact_quotient.h"

namespace spherepair {
namespace {

constexpr int NUMBERS = 1'000'000;

float any_float(std::mt19937& random) { return std::bit_cast<float>(uint(random())); }
bool is_normal(float x) { return exponent_field(x) != 255u; }

// What is a few ulp from x, where the last bit decides the rounding.
float near(std::mt19937& random, float x) {
  return std::bit_cast<float>(uint(std::bit_cast<uint>(x) + random() % 7 - 3));
}

void expect_same_quotient(float a, float b) {
  if (!is_normal(a) || !is_normal(b)) return;
  ASSERT_EQ(float_bits(corrected_quotient(a, b)), float_bits(quotient(a, b))) << fmt::format("{:a} / {:a}", a, b);
}
void expect_same_root(float x) {
  if (!is_normal(x)) return;
  ASSERT_EQ(float_bits(corrected_root(x)), float_bits(square_root(x))) << fmt::format("{:a}", x);
}

TEST(ContactQuotient, IsThatMadeBitByBit) {
  std::mt19937 random(67);
  for (int k = 0; k < NUMBERS; ++k) {
    const float a = any_float(random), b = any_float(random);
    expect_same_quotient(a, b);
    expect_same_quotient(near(random, a * b), b);
    expect_same_quotient(a, near(random, a));
  }
}

TEST(ContactQuotient, RootsToo) {
  std::mt19937 random(68);
  for (int k = 0; k < NUMBERS; ++k) {
    const float x = any_float(random);
    expect_same_root(x);
    expect_same_root(near(random, x * x));
  }
}

TEST(ContactQuotient, EdgesToo) {
  const float edges[] = {0.0f,     -0.0f, 1.0f,  -1.0f, 0x1p-126f,        -0x1p-126f, 0x1p-149f, 0x1.fffffep-127f,
                         0x1p127f, 2.0f,  0.5f,  3.0f,  0x1.fffffep+127f, 0x1p-125f,  4.0f,      0x1.fffffep-1f,
                         0x1p-64f, 1e30f, 1e-30f};
  for (const float a : edges) {
    expect_same_root(a);
    for (const float b : edges) expect_same_quotient(a, b);
  }
}

TEST(ContactQuotient, TheGuessOfAnyMachineWillDo) {
  std::mt19937 random(69);
  for (int k = 0; k < NUMBERS; ++k) {
    const uint b = 0x800000u + random() % 0x800000u, a = b + random() % b;
    const uint quotient = uint((uint64_t(a) << 24) / b);
    const Digits found = digits_of_quotient(a, b, quotient + random() % 129 - 64);
    ASSERT_EQ(found.whole, quotient) << a << " / " << b;
    ASSERT_EQ(uint64_t(found.rest), (uint64_t(a) << 24) - uint64_t(quotient) * b);

    const uint x = 0x800000u + random() % 0x1800000u;
    const Digits root = digits_of_root(x, uint(std::sqrt(double(uint64_t(x) << 25))) + random() % 33 - 16);
    const uint64_t whole = root.whole, square = uint64_t(x) << 25;
    ASSERT_TRUE(whole * whole <= square && square < (whole + 1) * (whole + 1)) << x;
    ASSERT_EQ(uint64_t(root.rest), square - whole * whole);
  }
}

// The quotient of exact divisions is a limit that a guess just below must reach.
TEST(ContactQuotient, ExactOnesAreReached) {
  for (const uint b : {0x800000u, 0xC00000u, 0xFFFFFFu})
    for (const uint a : {b, b + (b >> 1)})
      for (uint wrong = 0; wrong <= 128; ++wrong) {
        if ((uint64_t(a) << 24) % b != 0) continue;
        const uint quotient = uint((uint64_t(a) << 24) / b);
        const Digits found = digits_of_quotient(a, b, quotient + wrong - 64);
        EXPECT_TRUE(found.whole == quotient && found.rest == 0) << a << " / " << b << ", " << wrong;
      }
}

}  // namespace
}  // namespace spherepair
