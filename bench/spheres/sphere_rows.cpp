// SPDX-License-Identifier: MIT
#include "bench/spheres/sphere_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace spherepair {

void SphereRows::resize(uint64_t n, double radius, bool with_velocities, bool with_exact) {
  positions.assign(n, vec4{0, 0, 0, float(radius)});
  if (with_velocities) velocities.assign(n, vec4{0, 0, 0, 0});
  if (with_exact) exact.points.assign(n, Point3{}), exact.radii.assign(n, radius);
}

void SphereRows::add(double radius) {
  positions.push_back({0, 0, 0, float(radius)});
  velocities.push_back({0, 0, 0, 0});
  exact.points.push_back({}), exact.radii.push_back(radius);
}

void SphereRows::set(uint64_t sphere, Quantity quantity, const Decimal& number) {
  if (quantity >= QUANTITY_VX) {
    (&velocities[sphere].x)[quantity - QUANTITY_VX] = number.rounded;
    return;
  }
  (&positions[sphere].x)[quantity] = number.rounded;
  if (exact.points.empty()) return;
  (quantity == QUANTITY_RADIUS ? exact.radii[sphere] : exact.points[sphere][quantity]) = number.value;
}

// The shift of a centre plus the change of its radius. 2^-50 covers the roundings of this sum, nextafter the last one.
float largest_rounding(const SphereRows& rows) {
  double largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (rows.exact.points.size() > 1 << 16)
  for (size_t i = 0; i < rows.exact.points.size(); ++i) {
    const auto& [x, y, z] = rows.exact.points[i];
    const vec4& rounded = rows.positions[i];
    const double dx = x - double(rounded.x), dy = y - double(rounded.y), dz = z - double(rounded.z);
    const double dr = rows.exact.radii[i] - double(rounded.w);
    largest = std::max(largest, std::sqrt(dx * dx + dy * dy + dz * dz) + std::abs(dr));
  }
  return largest == 0 ? 0 : std::nextafter(float(largest * (1 + 0x1p-50)), INFINITY);
}

std::string at_most(double value) {
  const std::string text = fmt::format("{:.2g}", value);
  if (std::strtod(text.c_str(), nullptr) >= value) return text;
  return fmt::format("{:.2g}", value + 0.5 * std::pow(10, std::floor(std::log10(value)) - 1));
}

}  // namespace spherepair
