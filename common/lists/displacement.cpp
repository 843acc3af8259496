// SPDX-License-Identifier: MIT
#include "common/lists/displacement.h"

#include <cmath>

#include "common/lists/exact_sum.h"

namespace spherepair {
namespace {

using Component = ExactSum<8>;  // two coordinates, and three products of two terms each

Component component(const ListProblem& problem, const ListBox& box, const ListedPair& pair, size_t axis) {
  Component sum;
  sum.add(problem.set.points[pair.second][axis]);
  sum.add(-problem.firsts().points[pair.first][axis]);
  for (size_t k = 0; k < 3; ++k)
    if (pair.shift[k] != 0) sum.add_product(pair.shift[k], box.rows[k][axis]);
  return sum;
}

// Squares of three components and of c: at most (3 * 8 * 8 + 3 * 3) products.
using Squares = ExactSum<2 * (3 * 64 + 9)>;

template <typename Parts>
void add_square(Squares& sum, double sign, const Parts& parts) {
  for (auto a = parts.begin(); a != parts.end(); ++a) {
    sum.add_product(sign * *a, *a);
    for (auto b = std::next(a); b != parts.end(); ++b) sum.add_product(2 * sign * *a, *b);
  }
}

}  // namespace

double squared_gap(const ListProblem& problem, const ListBox& box, const ListedPair& pair) {
  Squares sum;
  add_square(sum, 1, problem.reach(pair.first, pair.second));
  for (size_t axis = 0; axis < 3; ++axis) add_square(sum, -1, component(problem, box, pair, axis));
  return sum.rounded();
}

// Rounding moves a component at most seven times, each time by 2^-53 of the sum of its terms' sizes at most. So 2^-50
// of that sum bounds them all. The squares, their sum, and c squared are each rounded four times at most.
bool is_within_reach(const ListProblem& problem, const ListBox& box, const ListedPair& pair) {
  const Point3 &a = problem.firsts().points[pair.first], &b = problem.set.points[pair.second];
  double squared = 0, error = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    double way = b[axis] - a[axis], sizes = std::abs(b[axis]) + std::abs(a[axis]);
    for (size_t k = 0; k < 3; ++k)
      if (pair.shift[k] != 0) {
        const double moved = pair.shift[k] * box.rows[k][axis];
        way += moved, sizes += std::abs(moved);
      }
    const double off = 0x1p-50 * sizes;
    squared += way * way;
    error += (2 * std::abs(way) + off) * off;
  }
  const auto [c0, c1, c2] = problem.reach(pair.first, pair.second);
  const double reach = c0 + c1 + c2, limit = reach * reach;
  error += 0x1p-49 * (squared + limit);
  if (squared + error < limit) return true;
  if (squared - error > limit) return false;
  const double gap = squared_gap(problem, box, pair);
  return gap > 0 || (gap == 0 && problem.inclusive);
}

Point3 displacement(const ListProblem& problem, const ListBox& box, const ListedPair& pair) {
  Point3 way;
  const Point3 &from = problem.firsts().points[pair.first], &to = problem.set.points[pair.second];
  const bool direct = pair.shift == Shift{};  // then one difference, rounded once; + 0.0: no -0
  for (size_t axis = 0; axis < 3; ++axis)
    way[axis] = direct ? to[axis] - from[axis] + 0.0 : component(problem, box, pair, axis).rounded();
  return way;
}

double length(const Point3& vector) {
  return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

}  // namespace spherepair
