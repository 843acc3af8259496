// SPDX-License-Identifier: MIT
#include "bench/spheres/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace spherepair {
namespace {

constexpr size_t many = 1 << 16;  // spheres from which on several threads share the work

// grown_radius: a float32 not below radius + reach. shrunk_radius: one not above radius - less, but not negative.
float grown_radius(float radius, float reach) {
  if (reach == 0) return radius;
  const float up = std::nextafter(std::max(radius, float(double(radius) + double(reach))), INFINITY);
  return std::min(up, std::numeric_limits<float>::max());
}
float shrunk_radius(float radius, double less) {
  if (less == 0) return radius;
  return std::nextafter(float(std::max(double(radius) - less, 0.0)), 0.0f);
}

// A multiple of a power of two near the extent: subtracting it keeps the last bits of almost all numbers.
double middle_of(const SphereRows& rows, int axis) {
  double low = INFINITY, high = -INFINITY;
  const size_t n = rows.exact.size();
#pragma omp parallel for schedule(static) reduction(min : low) reduction(max : high) if (n > many)
  for (size_t i = 0; i < n; ++i) {
    low = std::min(low, rows.exact[i][size_t(axis)]);
    high = std::max(high, rows.exact[i][size_t(axis)]);
  }
  if (!(high > low)) return low;
  const double unit = std::exp2(std::floor(std::log2(high - low)));
  return std::round((low / 2 + high / 2) / unit) * unit;
}

// Whether x - c is exact: its rounding error, which float64 can represent, is zero.
bool exact_difference(double x, double c) {
  const double difference = x - c, part = difference - x;
  return (x - (difference - part)) - (c + part) == 0;
}

bool loses_nothing(const SphereRows& rows, int axis, double shift) {
  const size_t n = rows.exact.size();
  bool all = true;
#pragma omp parallel for schedule(static) reduction(&& : all) if (n > many)
  for (size_t i = 0; i < n; ++i) all = all && exact_difference(rows.exact[i][size_t(axis)], shift);
  return all;
}

// A bound of how far rounding moved a sphere's surface: the shift of its centre plus the change of its radius. 2^-50
// covers the roundings of this sum, nextafter the rounding to float32.
float reach_of(const std::array<double, 4>& exact, const vec4& rounded, const std::array<double, 3>& shift) {
  const double dx = exact[0] - shift[0] - double(rounded.x), dy = exact[1] - shift[1] - double(rounded.y),
               dz = exact[2] - shift[2] - double(rounded.z), dr = exact[3] - double(rounded.w);
  const double way = std::sqrt(dx * dx + dy * dy + dz * dz) + std::abs(dr);
  return way == 0 ? 0 : std::nextafter(float(way * (1 + 0x1p-50)), INFINITY);
}

// Finds the reach of all spheres from their rounded positions.
void find_reach(const SphereRows& rows, Rounding& rounding) {
  std::vector<float> reach(rows.exact.size());
  float largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (reach.size() > many)
  for (size_t i = 0; i < reach.size(); ++i) {
    reach[i] = reach_of(rows.exact[i], rows.positions[i], rounding.shift);
    largest = std::max(largest, reach[i]);
  }
  rounding.largest = largest;
  if (largest > 0) rounding.reach = std::move(reach);
}

void shift_axis(SphereRows& rows, int axis, double middle) {
#pragma omp parallel for schedule(static) if (rows.exact.size() > many)
  for (size_t i = 0; i < rows.exact.size(); ++i)
    (&rows.positions[i].x)[axis] = float(rows.exact[i][size_t(axis)] - middle);
}

}  // namespace

void SphereRows::resize(uint64_t n, double radius, bool with_velocities, bool with_exact) {
  positions.assign(n, vec4{0, 0, 0, float(radius)});
  if (with_velocities) velocities.assign(n, vec4{0, 0, 0, 0});
  if (with_exact) exact.assign(n, {0, 0, 0, radius});
}

void SphereRows::add(double radius) {
  positions.push_back({0, 0, 0, float(radius)});
  velocities.push_back({0, 0, 0, 0});
  exact.push_back({0, 0, 0, radius});
}

void SphereRows::set(uint64_t sphere, Quantity quantity, const Decimal& number) {
  if (quantity >= QUANTITY_VX) {
    (&velocities[sphere].x)[quantity - QUANTITY_VX] = number.rounded;
    return;
  }
  (&positions[sphere].x)[quantity] = number.rounded;
  if (!exact.empty()) exact[sphere][quantity] = number.value;
}

Rounding round_rows(SphereRows& rows, bool may_shift) {
  Rounding rounding;
  find_reach(rows, rounding);
  if (rounding.largest == 0 || !may_shift) return rounding;
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = middle_of(rows, axis);
    if (middle == 0 || !loses_nothing(rows, axis, middle)) continue;
    rounding.shift[size_t(axis)] = middle;
    shift_axis(rows, axis, middle);
  }
  rounding.reach.clear();
  find_reach(rows, rounding);
  return rounding;
}

void widen(Rounding& rounding, double way) {
  for (float& reach : rounding.reach) reach = std::nextafter(float(double(reach) + way), INFINITY);
}

std::string at_most(double value) {
  const std::string text = fmt::format("{:.2g}", value);
  if (std::strtod(text.c_str(), nullptr) >= value) return text;
  return fmt::format("{:.2g}", value + 0.5 * std::pow(10, std::floor(std::log10(value)) - 1));
}

std::vector<vec4> grown(std::span<const vec4> spheres, std::span<const float> reach) {
  std::vector<vec4> all(spheres.begin(), spheres.end());
  for (size_t i = 0; i < all.size(); ++i) all[i].w = grown_radius(all[i].w, reach[i]);
  return all;
}

// A radius below its sphere's reach would become negative. So all radii also shrink by the largest such deficit, and no
// sum of two radii is too large.
std::vector<vec4> shrunk(std::span<const vec4> spheres, std::span<const float> reach) {
  std::vector<vec4> all(spheres.begin(), spheres.end());
  double lack = 0;
  for (size_t i = 0; i < all.size(); ++i) lack = std::max(lack, double(reach[i]) - double(all[i].w));
  for (size_t i = 0; i < all.size(); ++i) all[i].w = shrunk_radius(all[i].w, double(reach[i]) + lack);
  return all;
}

}  // namespace spherepair
