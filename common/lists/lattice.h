// SPDX-License-Identifier: MIT
// A periodic box in float64, rounded: how points come into it, and how many rows of it a reach spans. What is decided
// here is only where to look for pairs; what is a pair is decided by displacement.h.
#pragma once

#include "common/lists/list_problem.h"

namespace spherepair {

inline double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Without a call of the mathematical library, for numbers that fit into 32 bits.
inline int32_t floor_of(double x) {
  const auto whole = int32_t(x);
  return whole - (x < whole);
}
inline int32_t ceil_of(double x) { return -floor_of(-x); }

class Lattice {
 public:
  // Throws ListError if the periodic rows are 0 or nearly coplanar or collinear; `system` is for the message.
  Lattice(const ListBox& box, uint64_t system);

  // Fractional coordinates; 0 along rows that are not periodic.
  Point3 fraction(const Point3& point) const {
    Point3 fraction = {};
    for (size_t k = 0; k < 3; ++k)
      if (box_.periodic[k]) fraction[k] = dot(point, dual_[k]);
    return fraction;
  }
  // Upper bounds on the difference in fractional coordinates of two points at this distance, rounding included.
  Point3 spans(double distance) const {
    Point3 spans = {};
    for (size_t k = 0; k < 3; ++k)
      if (box_.periodic[k]) spans[k] = distance * dual_sizes_[k] * (1 + slack) + slack;
    return spans;
  }
  Point3 moved(const Point3& point, const Shift& shift) const {
    Point3 to = point;
    for (size_t k = 0; k < 3; ++k)
      if (shift[k] != 0)
        for (size_t axis = 0; axis < 3; ++axis) to[axis] += shift[k] * box_.rows[k][axis];
    return to;
  }
  const ListBox& box() const { return box_; }

  // The rows of the box; unit vectors perpendicular to them where it is not periodic.
  const std::array<Point3, 3>& axes() const { return axes_; }
  // dual()[k] . x is coordinate k of x along the axes.
  const std::array<Point3, 3>& dual() const { return dual_; }

 private:
  static constexpr double slack = 1e-6;
  ListBox box_;
  std::array<Point3, 3> axes_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, dual_ = axes_;
  Point3 dual_sizes_ = {};
};

}  // namespace spherepair
