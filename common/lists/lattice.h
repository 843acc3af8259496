// SPDX-License-Identifier: MIT
// A periodic box in float64, rounded: how points come into it, and how many rows of it a reach spans. What is decided
// here is only where to look for pairs; what is a pair is decided by displacement.h.
#pragma once

#include "common/lists/list_problem.h"

namespace spherepair {

class Lattice {
 public:
  // Throws ListError if the periodic rows are 0 or nearly coplanar or collinear; `system` is for the message.
  Lattice(const ListBox& box, uint64_t system);

  // Fractional coordinates; 0 along rows that are not periodic.
  Point3 fraction(const Point3& point) const;
  // Upper bounds on the difference in fractional coordinates of two points at this distance, rounding included.
  Point3 spans(double distance) const;
  Point3 moved(const Point3& point, const Shift& shift) const;
  const ListBox& box() const { return box_; }

  // The rows of the box; unit vectors perpendicular to them where it is not periodic.
  const std::array<Point3, 3>& axes() const { return axes_; }
  // dual()[k] . x is coordinate k of x along the axes.
  const std::array<Point3, 3>& dual() const { return dual_; }

 private:
  ListBox box_;
  std::array<Point3, 3> axes_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, dual_ = axes_;
};

}  // namespace spherepair
