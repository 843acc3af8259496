// SPDX-License-Identifier: MIT
// What a list of pairs is asked for: points or spheres, boxes, systems. What a pair is:
// include/spherepair/spherepair.h.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace spherepair {

using Point3 = std::array<double, 3>;
using Shift = std::array<int32_t, 3>;  // S: how many rows of the box are added

struct ListBox {
  std::array<Point3, 3> rows = {};  // not read where it is not periodic
  std::array<bool, 3> periodic = {};
  bool is_open() const { return !periodic[0] && !periodic[1] && !periodic[2]; }
};

// The points of all systems, one system after another. All lengths have one unit. Points in a device's memory have
// offsets alone here.
struct PointSet {
  std::vector<Point3> points;
  std::vector<double> radii;      // of each, not negative; none: the cutoff is for all
  std::vector<uint64_t> offsets;  // system b has the points offsets[b] to offsets[b + 1] - 1
  uint64_t size() const { return points.empty() && !offsets.empty() ? offsets.back() : points.size(); }
};

struct ListProblem {
  PointSet set, queries;
  bool asks = false;  // pairs of queries with points; else of points with points
  double cutoff = 0, skin = 0;
  std::vector<ListBox> boxes;  // one a system
  std::vector<std::array<uint32_t, 2>> exclusions;
  bool half = false, inclusive = false, self_pairs = false;

  const PointSet& firsts() const { return asks ? queries : set; }
  // c of a pair; the sum of these numbers is not rounded where a pair is decided.
  std::array<double, 3> reach(uint32_t first, uint32_t second) const {
    if (set.radii.empty()) return {cutoff, 0, skin};
    return {firsts().radii[first], set.radii[second], skin};
  }
};

enum class ListFault { argument, not_finite, range };

// What is wrong with a problem: which number, and what it may be.
class ListError : public std::invalid_argument {
 public:
  ListError(ListFault fault, const std::string& what) : std::invalid_argument(what), fault(fault) {}
  const ListFault fault;
};

constexpr int64_t most_points = 0x7FFFFFFF;  // indices have 32 bits, of which devices use 31

// Numbers other than 0 must lie between these, so that no square or product of two leaves float64.
constexpr double smallest_listed = 0x1p-450, largest_listed = 0x1p450;

// Throws the ListError of point i of a set, whose numbers are wrong.
[[noreturn]] void refuse_point(const std::string& points, const std::string& radii, uint64_t i, const Point3& point,
                               double radius);

// Throws ListError for the first thing that is wrong.
void check_problem(const ListProblem& problem);

}  // namespace spherepair
