// SPDX-License-Identifier: MIT
#include "bench/image/colour_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

double radius_of(const Start& start, const vec4& sphere) {
  return std::ldexp(double(sphere.w), -start.length_exponent);
}

}  // namespace

std::vector<double> values_of(ColourBy by, const Start& start, Search& search, const Motion::State& state) {
  std::vector<double> values = values_of(by, search, state);
  if (by == ColourBy::species) {
    if (start.species_index.size() != values.size())
      throw std::invalid_argument(
          fmt::format("--color species: {} has no species: a file with a column of names or types has", start.label));
    std::ranges::copy(start.species_index, values.begin());
  }
  if (by == ColourBy::radius)
    for (double& radius : values) radius = std::ldexp(radius, -start.length_exponent);
  return values;
}

std::vector<double> range_of_speeds(std::vector<double> speeds) {
  const auto last = speeds.begin() + ptrdiff_t(speeds.size() * 98 / 100);
  std::ranges::nth_element(speeds, last);
  return {0, *last > 0 ? *last : std::ranges::max(speeds)};
}

Colouring colouring_of(ColourBy by, const std::vector<Start>& starts, std::vector<double> values, bool clipped) {
  const Start& first = starts.front();
  if (by == ColourBy::speed && std::ranges::max(values) == 0)
    throw std::invalid_argument(
        fmt::format("--color speed: all spheres of {} are at rest{}", first.label,
                    first.at_rest ? ": choose another --color" : " in the image: give --steps"));
  for (size_t k = 1; !clipped && k < starts.size(); ++k) {
    const std::vector<uint>& species = starts[k].species_index;
    if (by == ColourBy::species) values.insert(values.end(), species.begin(), species.end());
    for (const vec4& sphere : starts[k].scene.positions)
      if (by == ColourBy::radius) values.push_back(radius_of(starts[k], sphere));
  }
  if (by == ColourBy::species) return {first.species, values};
  const char* unit = first.at_rest ? ", in the file's unit" : by == ColourBy::speed ? ", m/s" : ", m";
  return {by, values, unit, clipped};
}

}  // namespace spherepair
