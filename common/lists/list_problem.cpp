// SPDX-License-Identifier: MIT
#include "common/lists/list_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

bool is_listed(double number) {
  const double size = std::abs(number);
  return size == 0 || (size >= smallest_listed && size <= largest_listed);  // no NaN
}

bool is_radius(double number) { return number >= 0 && is_listed(number); }

void check_number(double number, const std::string& name, bool may_be_negative) {
  if (!std::isfinite(number)) throw ListError(ListFault::not_finite, fmt::format("{} is {}", name, number));
  if (number < 0 && !may_be_negative)
    throw ListError(ListFault::argument, fmt::format("{} is {}, but must not be negative", name, number));
  if (!is_listed(number))
    throw ListError(ListFault::range,
                    fmt::format("{} is {}: numbers other than 0 must be from 2^-450 to 2^450 in size, "
                                "so choose another unit of length",
                                name, number));
}

void check_set(const PointSet& set, const std::string& points, const std::string& radii) {
  const auto n = int64_t(set.points.size());
  int64_t first = n;  // that is wrong
  const auto is_right = [&](int64_t i) {
    const auto& [x, y, z] = set.points[i];
    return is_listed(x) && is_listed(y) && is_listed(z) && (set.radii.empty() || is_radius(set.radii[i]));
  };
  if (n <= 1 << 14) {  // without OpenMP, whose regions cost half a microsecond
    for (first = 0; first < n && is_right(first);) ++first;
  } else {
#pragma omp parallel for schedule(static) reduction(min : first)
    for (int64_t i = 0; i < n; ++i)
      if (!is_right(i)) first = std::min(first, i);
  }
  if (first < n)
    refuse_point(points, radii, uint64_t(first), set.points[first], set.radii.empty() ? 0 : set.radii[first]);
}

void check_exclusions(const ListProblem& problem) {
  const uint64_t sizes[] = {problem.firsts().size(), problem.set.size()};
  for (uint64_t e = 0; e < problem.exclusions.size(); ++e)
    for (size_t k : {0, 1})
      if (problem.exclusions[e][k] >= sizes[k])
        throw ListError(ListFault::argument,
                        fmt::format("exclusions[{}] names {} {}, but there are {}", e,
                                    k == 0 && problem.asks ? "query" : "point", problem.exclusions[e][k], sizes[k]));
}

}  // namespace

void refuse_point(const std::string& points, const std::string& radii, uint64_t i, const Point3& point, double radius) {
  for (size_t axis = 0; axis < 3; ++axis)
    check_number(point[axis], fmt::format("{}[{}].{}", points, i, "xyz"[axis]), true);
  check_number(radius, fmt::format("{}[{}]", radii, i), false);
  throw ListError(ListFault::argument, fmt::format("{}[{}] changed while it was read", points, i));
}

void check_problem(const ListProblem& problem) {
  check_number(problem.cutoff, "cutoff", false);
  check_number(problem.skin, "skin", false);
  if (!problem.set.radii.empty() && problem.cutoff != 0)
    throw ListError(ListFault::argument, "there are radii and a cutoff: give one of them (and a skin)");
  check_set(problem.set, "positions", "radii");
  check_set(problem.queries, "queries", "query_radii");
  for (size_t b = 0; b < problem.boxes.size(); ++b)
    for (size_t k = 0; k < 3; ++k)
      if (problem.boxes[b].periodic[k])
        for (size_t axis = 0; axis < 3; ++axis)
          check_number(problem.boxes[b].rows[k][axis], fmt::format("boxes[{}], row {}, {}", b, k, "xyz"[axis]), true);
  check_exclusions(problem);
}

}  // namespace spherepair
