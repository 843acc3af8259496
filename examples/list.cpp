// SPDX-License-Identifier: MIT
//
// Overlaps in C++: which of five spheres in a row overlap, on the CPU. Spheres 0 and 1 touch, which is no overlap.
// Prints the two pairs with their distances, what overlaps sphere 3, and the message of an error.
#include <array>
#include <iostream>
#include <limits>
#include <spherepair/spherepair.hpp>
#include <vector>

int main() {
  std::vector<std::array<double, 3>> centers;
  for (int n = 0; n < 5; ++n) centers.push_back({double(n), 0, 0});
  const std::vector<double> radii = {0.5, 0.5, 0.4, 0.7, 0.5};

  try {
    spherepair::Context context("cpu");
    const auto overlaps = context.list({.positions = centers, .radii = radii, .half = true}, SP_DISTANCES);
    for (size_t k = 0; k < overlaps.first().size(); ++k)
      std::cout << overlaps.first()[k] << " overlaps " << overlaps.second()[k] << ", distance "
                << overlaps.distances()[k] << '\n';

    // A full list has each pair twice, so the rows of one sphere are all its neighbours.
    const auto neighbours = context.list({.positions = centers, .radii = radii}, SP_OFFSETS);
    const auto begin = size_t(neighbours.offsets()[3]), end = size_t(neighbours.offsets()[4]);
    std::cout << "sphere 3 overlaps";
    for (const int32_t j : neighbours.second().subspan(begin, end - begin)) std::cout << ' ' << j;
    std::cout << '\n';
    if (overlaps.size() != 2 || end - begin != 2) return 1;
  } catch (const spherepair::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }

  try {
    centers[1][2] = std::numeric_limits<double>::quiet_NaN();
    spherepair::Context("cpu").count({.positions = centers, .radii = radii});
  } catch (const spherepair::Error& error) {
    std::cout << "refused: " << error.what() << '\n';
    return error.status() == SP_E_NONFINITE ? 0 : 1;
  }
  return 1;
}
