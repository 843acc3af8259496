// SPDX-License-Identifier: MIT
// The exact stages of lists as kernels have them, float64 and integers, against those of the CPU, float64 and
// expansions.
#include "common/lists/displacement.h"
#include "common/shared/list_exact.h"
#include "tests/oracle/adversarial.h"

namespace spherepair {
namespace {

ListRows rows_of(const ListBox& box) {
  ListRows rows;
  for (size_t k = 0; k < 9; ++k) rows.of[k] = box.rows[k / 3][k % 3];
  return rows;
}

// Both answers for a pair, which must be equal.
bool both_within_reach(const ListProblem& problem, const ListedPair& pair) {
  const Point3 &a = problem.set.points[0], &b = problem.set.points[1];
  const bool expected = is_within_reach(problem, problem.boxes[0], pair);
  const dvec4 first{a[0], a[1], a[2], problem.set.radii[0]}, second{b[0], b[1], b[2], problem.set.radii[1]};
  EXPECT_EQ(list_within_reach(first, second, rows_of(problem.boxes[0]), pair.shift[0], pair.shift[1], pair.shift[2],
                              problem.cutoff, problem.skin, problem.inclusive),
            expected);
  return expected;
}

double nudged(double number, int units) {
  for (; units > 0; --units) number = std::nextafter(number, INFINITY);
  for (; units < 0; ++units) number = std::nextafter(number, -INFINITY);
  return number;
}

// Tangent spheres by the numbers 3, 4 and 5, through images of a box that is far larger, or far smaller, than they are;
// then each number is moved by some units in the last place.
TEST(ListExact, KernelsDecideAsTheCpu) {
  Random random(83);
  int within = 0, cases = 0;
  for (const int exponent : {-430, -40, 0, 17, 430})
    for (int k = 0; k < 4000; ++k, ++cases) {
      const double unit = std::ldexp(1, exponent),
                   edge = unit * std::ldexp(random.between(1, 7), random.between(-12, 12));
      ListProblem problem;
      problem.boxes = {{{{{edge, 0, 0}, {edge / 2, edge, 0}, {0, edge / 4, edge}}}, {true, true, true}}};
      const Shift shift = {random.between(-3, 3), random.between(-100000, 100000), random.between(-3, 3)};
      Point3 way = {3 * unit, 4 * unit, 0}, from = {unit * random.between(-9, 9), unit * random.between(-9, 9), 0};
      Point3 to;
      for (size_t axis = 0; axis < 3; ++axis) {
        to[axis] = from[axis] + way[axis];
        for (size_t row = 0; row < 3; ++row) to[axis] -= shift[row] * problem.boxes[0].rows[row][axis];
        to[axis] = nudged(to[axis], random.between(-1, 1) * (k % 3));
      }
      problem.set = {{from, to}, {nudged(2 * unit, random.between(-1, 1)), 2 * unit}, {0, 2}};
      problem.skin = nudged(unit, random.between(-1, 1) * (k % 2));
      problem.inclusive = k % 5 == 0;
      within += both_within_reach(problem, {0, 1, shift});
      if (HasFailure()) FAIL() << "2^" << exponent << ", case " << k;
    }
  EXPECT_GT(within, cases / 10);
  EXPECT_LT(within, cases * 9 / 10);
}

// The code keeps the order of numbers, and its bounds hold them.
TEST(ListExact, BoundsOfExtremesHoldTheNumbers) {
  Random random(84);
  double last = -INFINITY;
  std::vector<double> numbers = {0.0, -0.0};
  for (int k = 0; k < 2000; ++k) numbers.push_back(std::ldexp(random.uniform(-2, 2), random.between(-440, 440)));
  std::ranges::sort(numbers);
  for (const double x : numbers) {
    EXPECT_LE(bound_below(~ordered_high(x)), x);
    EXPECT_GE(bound_above(ordered_high(x)), x);
    EXPECT_GE(ordered_high(x), ordered_high(last));
    EXPECT_NE(ordered_high(x), 0u);
    last = x;
  }
  EXPECT_EQ(bound_above(0), 0.0) << "none";
}

}  // namespace
}  // namespace spherepair
