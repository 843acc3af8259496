// SPDX-License-Identifier: MIT
// The tensor cores' filter, emulated with roundings against it: no colliding pair may be lost, and few others be near.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/scene/scene.h"
#include "common/shared/tensor_form.h"
#include "tests/oracle/adversarial.h"
#include "tests/oracle/oracle.h"

namespace spherepair {
namespace {

using Halves = std::array<double, 16>;

Halves halves_of(const std::array<uint, 8>& words) {
  Halves halves;
  for (uint k = 0; k < 16; ++k) halves[k] = half_value(words[k / 2] >> (k % 2 * 16) & 0xFFFFu);
  return halves;
}
std::array<uint, 8> words_of(const TensorForm& form) {
  return {form.low.x, form.low.y, form.low.z, form.low.w, form.high.x, form.high.y, form.high.z, form.high.w};
}
Halves column(const TensorForm& form) { return halves_of(words_of(form)); }
Halves row(const TensorForm& form) {
  const std::array<uint, 8> words = words_of(form);
  std::array<uint, 8> turned;
  for (uint k = 0; k < 8; ++k) turned[k] = words[tensor_row_source(k)] ^ tensor_row_signs(k);
  return halves_of(turned);
}

// How tensor cores add: in blocks of so many products, cut so many bits below the greatest; `up`: every cut goes away
// from the sign that says near, which no hardware does.
struct Rounding {
  int block, bits;
  bool up;
};
constexpr Rounding roundings[] = {{4, 23, true}, {4, 23, false}, {8, 24, true}, {16, 23, true}, {16, 25, false}};

double cut(double x, int exponent, bool up) {
  const double unit = std::ldexp(1.0, exponent);
  return (up ? std::ceil(x / unit) : std::trunc(x / unit)) * unit;
}

double sum_of_products(const Halves& a, const Halves& b, const std::array<int, 16>& order, Rounding rounding) {
  double sum = 0;
  for (int first = 0; first < 16; first += rounding.block) {
    int greatest = sum != 0 ? std::ilogb(sum) : -1000;
    for (int k = first; k < first + rounding.block; ++k) {
      const double x = a[order[k]], y = b[order[k]];
      if (x * y != 0) greatest = std::max(greatest, std::ilogb(x) + std::ilogb(y));
    }
    if (greatest == -1000) continue;
    double block = cut(sum, greatest - rounding.bits, rounding.up);
    for (int k = first; k < first + rounding.block; ++k)
      block += cut(a[order[k]] * b[order[k]], greatest - rounding.bits, rounding.up);
    sum = block == 0 ? 0 : cut(block, std::ilogb(block) - 23, rounding.up);
  }
  return sum;
}

struct TestPair {
  vec4 a, b, frame;
};

// Centres up to the corners of a box of any size, or in its middle, far from the origin or around it, and radii of up
// to that size that make them tangent, collide by one ulp, or collide by more.
TestPair hard_pair(Random& random) {
  const int exponent = random.below(3) ? random.between(-20, 20) : random.between(-90, 90);
  const double part = random.below(4) ? 1.0 : std::exp2(random.uniform(-20, 0));
  const double extent = std::ldexp(4095.0 * part, exponent);
  const double far = random.below(2) ? 0 : std::ldexp(random.uniform(-1, 1), exponent + random.between(12, 26));
  const double origin[] = {double(float(far)), double(float(-0.7 * far)), double(float(0.3 * far))};
  const double reach = extent * std::exp2(random.below(20) ? random.uniform(-16, 0) : random.uniform(-40, 0));
  const bool corner = random.below(4) != 0, radial = random.below(3) == 0;
  double centre[3], way[3], norm = 0;
  for (int k = 0; k < 3; ++k) {
    centre[k] = corner ? extent * double(random.sign()) : random.uniform(-extent, extent);
    way[k] = radial ? -centre[k] * random.uniform(0, 1) : random.uniform(-1, 1);
    norm += way[k] * way[k];
  }
  const double share = random.below(2) ? 0.5 : random.uniform(0, 1);
  const double distance = reach * (random.below(3) ? 1 - std::exp2(random.uniform(-26, -12)) : random.uniform(0, 1));
  float a[3], b[3];
  for (int k = 0; k < 3; ++k) {
    a[k] = float(origin[k] + centre[k]);
    b[k] = float(origin[k] + std::clamp(centre[k] + way[k] / std::sqrt(norm) * distance, -extent, extent));
  }
  const float scale = float(std::ldexp(1.0, -exponent));
  TestPair pair = {{a[0], a[1], a[2], float(reach * share)},
                   {b[0], b[1], b[2], float(reach * (1 - share))},
                   {float(origin[0]), float(origin[1]), float(origin[2]), scale}};
  if (random.below(2)) return pair;
  const double x = double(a[0]) - b[0], y = double(a[1]) - b[1], z = double(a[2]) - b[2];
  pair.b.w = float(std::max(0.0, std::sqrt(x * x + y * y + z * z) - double(pair.a.w)));
  return pair;
}

// What the margin was computed from: the squares of scaled coordinates and radii.
double squares(const TestPair& pair) {
  double sum = 0;
  for (const vec4& v : {pair.a, pair.b})
    for (const double x :
         {double(v.x) - pair.frame.x, double(v.y) - pair.frame.y, double(v.z) - pair.frame.z, double(v.w)})
      sum += x * pair.frame.w * x * pair.frame.w;
  return sum;
}

TEST(TensorForm, NoCollidingPairIsLostHoweverTensorCoresRound) {
  Random random(1);
  uint64_t colliding = 0, lost = 0, lost_without_margin = 0;
  for (int turn = 0; turn < 200'000; ++turn) {
    TestPair pair = hard_pair(random);
    for (int ulps = 0; ulps < 3 && relation(pair.a, pair.b) != Relation::overlapping; ++ulps)
      pair.b.w = nudged(pair.b.w, 1);
    if (relation(pair.a, pair.b) != Relation::overlapping) continue;
    ++colliding;
    std::array<int, 16> order;
    std::iota(order.begin(), order.end(), 0);
    for (size_t k = 16; k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
    const Halves a = row(tensor_form(pair.a, pair.frame)), b = column(tensor_form(pair.b, pair.frame));
    const double margin = 0x1p-18 * squares(pair) + 2 * double(TENSOR_UNDERFLOW);
    for (const Rounding& rounding : roundings) {
      const double sum = sum_of_products(a, b, order, rounding);
      lost += !(sum < -0.5);  // a half that is not 0
      lost_without_margin += !(sum + margin < 0);
    }
  }
  EXPECT_GT(colliding, 150'000u);
  EXPECT_EQ(lost, 0u);
  EXPECT_GT(lost_without_margin, colliding / 2) << "these pairs would not tell whether there is a margin";
}

TEST(TensorForm, FewPairsThatAreApartAreNear) {
  const Scene scene = make_scene({.name = "uniform", .n = 3000});
  vec4 low = scene.positions[0], high = low;
  for (const vec4& v : scene.positions) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z), 0};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z), v.w};
  }
  const vec4 frame = tensor_frame(low, high);
  std::vector<Halves> rows, columns;
  for (const vec4& v : scene.positions) {
    rows.push_back(row(tensor_form(v, frame)));
    columns.push_back(column(tensor_form(v, frame)));
  }
  uint64_t near = 0;
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t j = i + 1; j < rows.size(); ++j)
      near += std::inner_product(rows[i].begin(), rows[i].end(), columns[j].begin(), 0.0) < 0;
  const uint64_t colliding = brute_force_pairs(scene.positions).size();
  EXPECT_GE(near, colliding);
  EXPECT_LE(near, colliding + colliding / 50);
}

TEST(TensorForm, FramesHoldTheirBoxInRange) {
  for (const float size : {0x1p-149f, 0x1p-101f, 1e-20f, 1.0f, 4096.0f, 1e20f, 0x1p127f})
    for (const float at : {0.0f, -size, size}) {
      const vec4 low = {std::min(at, 0.0f) - size / 2, 0, 0, 0}, high = {std::max(at, 0.0f), size / 2, 0, size / 4};
      const vec4 frame = tensor_frame(low, high);
      const float width = (high.x - low.x) * frame.w;
      for (const vec4& corner : {low, high}) {
        EXPECT_LT(std::abs((corner.x - frame.x) * frame.w), TENSOR_RANGE) << size;
        EXPECT_LT(std::abs((corner.y - frame.y) * frame.w), TENSOR_RANGE) << size;
      }
      EXPECT_GE(width, size < 0x1p-90f ? 0 : TENSOR_RANGE / 4) << size;
    }
}

TEST(TensorForm, WhatDoesNotFitIsNearEverythingAndPaddingNothing) {
  const vec4 frame = {0, 0, 0, 1};
  const float infinite = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<TensorForm> fitting;
  for (const float x : {-4095.9f, 0.0f, 4095.9f})
    for (const float r : {0.0f, 1.0f, 4095.9f}) fitting.push_back(tensor_form({x, -x, x, r}, frame));
  const auto sum = [](const TensorForm& a, const TensorForm& b) {
    return sum_of_products(row(a), column(b), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, roundings[0]);
  };
  std::vector<vec4> beyond = {
      {nan, 0, 0, 1}, {0, infinite, 0, 1}, {0, 0, -4096, 1}, {0, 0, 0, 4096}, {3e38f, 0, 0, nan}};
  for (const TensorForm& each : fitting) {
    for (const vec4& sphere : beyond) {
      EXPECT_LT(sum(tensor_form(sphere, frame), each), 0);
      EXPECT_LT(sum(each, tensor_form(sphere, frame)), 0);
    }
    EXPECT_GT(sum(never_near_form(), each), 0);
    EXPECT_GT(sum(each, never_near_form()), 0);
  }
  EXPECT_LT(sum(tensor_form(beyond[0], frame), tensor_form(beyond[1], frame)), 0);
}

TEST(TensorForm, TilesAreThoseOfTheTriangle) {
  for (const uint64_t n : {1u, 127u, 128u, 129u, 512u, 513u, 5000u, 65536u}) {
    uint64_t tiles = 0;
    for (uint64_t row = 0; row < n; row += TENSOR_ROWS)
      for (uint64_t column = row; column < n; column += TENSOR_COLUMNS) ++tiles;
    EXPECT_EQ(tensor_tiles(n), tiles) << n;
  }
}

}  // namespace
}  // namespace spherepair
