// SPDX-License-Identifier: MIT
#include "bench/output/pair_geometry.h"

#include <cmath>

#include "common/lists/exact_sum.h"

namespace spherepair {
namespace {

using Squares = ExactSum<24>;

// Adds sign * (a + b)^2. No product under- or overflows: float32 squared is far within float64.
void add_square(Squares& sum, double sign, float a, float b) {
  const double high = double(a) + b, from_b = high - a, low = (a - (high - from_b)) + (b - from_b);
  sum.add_product(sign * high, high);
  if (low == 0) return;
  sum.add_product(2 * sign * high, low);
  sum.add_product(sign * low, low);
}

void subtract_squared_distance(Squares& sum, const vec4& a, const vec4& b) {
  add_square(sum, -1, a.x, -b.x);
  add_square(sum, -1, a.y, -b.y);
  add_square(sum, -1, a.z, -b.z);
}

// The squared sum of the radii minus the squared distance of the centres, with the right sign and an error of at most
// one unit in the last place. The overlap is this over the sum of radii and distance, which avoids the cancellation of
// a difference of lengths.
double squared_gap(const vec4& a, const vec4& b) {
  Squares sum;
  add_square(sum, 1, a.w, b.w);
  subtract_squared_distance(sum, a, b);
  return sum.rounded();
}

using Vector = std::array<double, 3>;
Vector between(const vec4& a, const vec4& b) { return {double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z}; }

// Squares of float32 and of their differences are far within float64.
double length(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

double distance_of(const Pair& pair, std::span<const vec4> spheres) {
  return length(between(spheres[pair.first], spheres[pair.second]));
}

Contact contact_of(const Pair& pair, std::span<const vec4> spheres, const std::array<double, 3>& shift) {
  const vec4 &a = spheres[pair.first], &b = spheres[pair.second];
  const auto [dx, dy, dz] = between(a, b);
  const double distance = length({dx, dy, dz}), radii = double(a.w) + b.w;
  Contact contact{.overlap = 0, .normal = {}, .point = {}};
  if (radii + distance > 0) contact.overlap = squared_gap(a, b) / (radii + distance);
  if (distance > 0) contact.normal = {dx / distance, dy / distance, dz / distance};
  const double along = (distance + (double(a.w) - b.w)) / 2;
  contact.point = {a.x + along * contact.normal[0] + shift[0], a.y + along * contact.normal[1] + shift[1],
                   a.z + along * contact.normal[2] + shift[2]};
  return contact;
}

float radius_above(double cutoff) { return std::nextafter(float(cutoff / 2), INFINITY); }

bool is_within(const Pair& pair, std::span<const vec4> spheres, double cutoff) {
  constexpr double margin = 0x1p-48;  // more than the roundings of both squares
  const double squared = std::pow(distance_of(pair, spheres), 2), limit = cutoff * cutoff;
  if (squared < limit * (1 - margin)) return true;
  if (squared > limit * (1 + margin)) return false;
  Squares sum;
  sum.add_product(cutoff, cutoff);
  subtract_squared_distance(sum, spheres[pair.first], spheres[pair.second]);
  return sum.rounded() >= 0;
}

}  // namespace spherepair
