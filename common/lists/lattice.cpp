// SPDX-License-Identifier: MIT
#include "common/lists/lattice.h"

#include <fmt/format.h>

#include <cmath>

namespace spherepair {
namespace {

// A box whose volume is this part of the product of its edges has duals with a relative error of about 2^-53 over it:
// far below the slack of spans().
constexpr double flattest = 1e-7;

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point3 scaled(const Point3& a, double by) { return {a[0] * by, a[1] * by, a[2] * by}; }

// Unit vectors that complete the periodic rows to a basis, perpendicular to them.
std::array<Point3, 3> completed(const ListBox& box) {
  std::array<Point3, 3> rows = {};
  std::array<double, 3> sizes = {};
  for (size_t k = 0; k < 3; ++k)
    if (box.periodic[k]) {
      sizes[k] = std::sqrt(dot(box.rows[k], box.rows[k]));
      rows[k] = scaled(box.rows[k], 1 / sizes[k]);
    }
  for (size_t k = 0; k < 3; ++k) {
    if (box.periodic[k]) continue;
    const Point3 &a = rows[(k + 1) % 3], &b = rows[(k + 2) % 3];
    Point3 normal = cross(a, b);
    if (dot(normal, normal) == 0) {  // at most one of the two is known yet: any direction that is far from it
      const Point3& known = dot(a, a) > 0 ? a : b;
      Point3 axis = {};
      size_t least = 0;
      for (size_t n = 1; n < 3; ++n)
        if (std::abs(known[n]) < std::abs(known[least])) least = n;
      axis[least] = 1;
      normal = dot(known, known) > 0 ? cross(known, axis) : axis;
    }
    rows[k] = scaled(normal, 1 / std::sqrt(dot(normal, normal)));
  }
  return rows;
}

}  // namespace

Lattice::Lattice(const ListBox& box, uint64_t system) : box_(box) {
  if (box.is_open()) return;
  const std::array<Point3, 3> rows = completed(box);
  const double volume = dot(rows[0], cross(rows[1], rows[2]));
  if (!(std::abs(volume) >= flattest))
    throw ListError(ListFault::argument,
                    fmt::format("boxes[{}]: its periodic rows span no volume (they are 0, or within {} of lying in a "
                                "plane or on a line)",
                                system, flattest));
  for (size_t k = 0; k < 3; ++k) {
    axes_[k] = box.periodic[k] ? box.rows[k] : rows[k];
    const double edge = box.periodic[k] ? std::sqrt(dot(box.rows[k], box.rows[k])) : 1;
    dual_[k] = scaled(cross(rows[(k + 1) % 3], rows[(k + 2) % 3]), 1 / (volume * edge));
    dual_sizes_[k] = std::sqrt(dot(dual_[k], dual_[k]));
  }
}

}  // namespace spherepair
