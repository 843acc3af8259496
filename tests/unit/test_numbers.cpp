// SPDX-License-Identifier: MIT
// The arithmetic of motion: quotients and square roots against the CPU's and against wider numbers, products and sums
// of compensated numbers.
#include <fmt/format.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "common/shared/wide.h"
#include "tests/oracle/adversarial.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
constexpr int NUMBERS = 500'000;

// Any float whose exponent is between these.
float float_between(Random& random, int low, int high) {
  const float digits = 1 + std::ldexp(float(random.between(0, (1 << 23) - 1)), -23);
  return std::ldexp(random.between(0, 1) ? digits : -digits, random.between(low, high));
}

// What is at a distance of few ulp from a square or a product, where rounding is decided by the last bit.
float near_hard(Random& random, float x) { return nudged(x, random.between(-3, 3)); }

TEST(Numbers, QuotientsAreCorrectlyRounded) {
  Random random(31);
  for (int k = 0; k < NUMBERS; ++k) {
    const float b = float_between(random, -60, 60), c = float_between(random, -60, 60);
    const float a = k % 2 == 0 ? float_between(random, -60, 60) : near_hard(random, b * c);
    ASSERT_EQ(float_bits(quotient(a, b)), float_bits(a / b)) << fmt::format("{:a} / {:a}", a, b);
  }
}

TEST(Numbers, SquareRootsAreCorrectlyRounded) {
  Random random(32);
  for (int k = 0; k < NUMBERS; ++k) {
    const float c = std::abs(float_between(random, -62, 62));
    const float x = k % 2 == 0 ? std::abs(float_between(random, -126, 127)) : std::abs(near_hard(random, c * c));
    ASSERT_EQ(float_bits(square_root(x)), float_bits(std::sqrt(x))) << fmt::format("{:a}", x);
  }
}

TEST(Numbers, EdgesOfQuotientsAndSquareRoots) {
  constexpr float largest = std::numeric_limits<float>::max();
  EXPECT_EQ(quotient(1.0f, 0.0f), largest);
  EXPECT_EQ(quotient(-1.0f, 0.0f), -largest);
  EXPECT_EQ(float_bits(quotient(0.0f, 3.0f)), 0u);
  EXPECT_EQ(quotient(largest, 0.5f), largest);
  EXPECT_EQ(float_bits(quotient(0x1p-126f, 2.0f)), 0u) << "what would be denormal is 0";
  EXPECT_EQ(quotient(0x1p-126f, 1.0f), 0x1p-126f);
  EXPECT_EQ(square_root(0.0f), 0.0f);
  EXPECT_EQ(square_root(-4.0f), 0.0f);
  EXPECT_EQ(square_root(0x1p-130f), 0.0f) << "denormals count as 0";
  EXPECT_EQ(square_root(largest), std::sqrt(largest));
  EXPECT_EQ(times(0x1p-50f, 0x1p-51f), 0.0f);
  EXPECT_EQ(times(0x1p-50f, 0x1p-50f), 0x1p-100f);
}

Two two_of(Random& random, int low, int high) {
  const float hi = float_between(random, low, high);
  return ordered_sum(hi, hi * float(random.uniform(-1, 1)) * 0x1p-25f);
}
Quad quad(Two x) { return Quad(x.hi) + Quad(x.lo); }
Quad quad(double x) { return Quad(x); }

// The largest relative errors of a quotient, a square root and a product over many numbers.
struct Worst {
  double quotient = 0, root = 0, product = 0, sum = 0;
};
template <typename Make>
Worst worst_of(Make make) {
  Worst worst;
  const auto keep = [](double& largest, const Quad& given, const Quad& wanted) {
    largest = std::max(largest, double(abs((given - wanted) / wanted)));
  };
  for (int k = 0; k < NUMBERS / 5; ++k) {
    const auto a = make(), b = make();
    keep(worst.quotient, quad(quotient(a, b)), quad(a) / quad(b));
    keep(worst.product, quad(times(a, b)), quad(a) * quad(b));
    const Quad sum = quad(a) + quad(b);  // relative to the terms: what cancels had been rounded before
    worst.sum = std::max(worst.sum, double(abs(quad(plus(a, b)) - sum) / (abs(quad(a)) + abs(quad(b)))));
    const auto square = times(a, a);
    keep(worst.root, quad(square_root(square)), sqrt(quad(square)));
  }
  return worst;
}

TEST(Numbers, CompensatedErrors) {
  Random random(33);
  const Worst worst = worst_of([&] { return two_of(random, -20, 20); });
  fmt::print("compensated: quotient 2^{:.1f}, root 2^{:.1f}, product 2^{:.1f}, sum 2^{:.1f}\n",
             std::log2(worst.quotient), std::log2(worst.root), std::log2(worst.product), std::log2(worst.sum));
  EXPECT_LE(worst.quotient, 0x1p-45);
  EXPECT_LE(worst.root, 0x1p-45);
  EXPECT_LE(worst.product, 0x1p-45);
  EXPECT_LE(worst.sum, 0x1p-47);
}

TEST(Numbers, DoubleErrorsAreWithinTwoUlp) {
  Random random(34);
  const auto any = [&] {
    return std::ldexp(random.uniform(1, 2) * (random.between(0, 1) ? 1 : -1), random.between(-40, 40));
  };
  const Worst worst = worst_of(any);
  fmt::print("float64: quotient {:.2f} ulp, root {:.2f} ulp at most\n", worst.quotient * 0x1p52, worst.root * 0x1p52);
  EXPECT_LE(worst.quotient, 2 * 0x1p-52);
  EXPECT_LE(worst.root, 2 * 0x1p-52);
  EXPECT_EQ(square_root(0.0), 0.0);
  EXPECT_EQ(square_root(-1.0), 0.0);
}

TEST(Numbers, ProductsOfFloatsAreExact) {
  Random random(35);
  for (int k = 0; k < NUMBERS; ++k) {
    const float a = float_between(random, -30, 30), b = float_between(random, -30, 30);
    const Two product = exact_product(a, b), sum = exact_sum(a, b);
    ASSERT_EQ(double(product.hi) + double(product.lo), double(a) * double(b)) << fmt::format("{:a} * {:a}", a, b);
    ASSERT_EQ(quad(sum), Quad(a) + Quad(b)) << fmt::format("{:a} + {:a}", a, b);
  }
}

}  // namespace
}  // namespace spherepair
