// SPDX-License-Identifier: MIT
//
// Many small systems in C++: 1,000 periodic boxes of 10 to 40 random points each, in one call.
// Prints the number of pairs of all systems and of the first system; a separate call confirms the second number.
#include <iostream>
#include <random>
#include <span>
#include <spherepair/spherepair.hpp>
#include <vector>

int main() {
  std::mt19937 random(1);
  std::vector<spherepair::Box> boxes;
  std::vector<int64_t> offsets = {0};
  std::vector<double> positions;
  for (int system = 0; system < 1000; ++system) {
    const double edge = std::uniform_real_distribution(2.0, 5.0)(random);
    const int points = std::uniform_int_distribution(10, 40)(random);
    boxes.push_back(spherepair::Box::orthogonal(edge, edge, edge));
    offsets.push_back(offsets.back() + points);
    for (int n = 0; n < 3 * points; ++n) positions.push_back(std::uniform_real_distribution(0.0, edge)(random));
  }

  try {
    spherepair::Context context("cpu");
    const auto list = context.list(
        {.positions = positions, .cutoff = 1.5, .boxes = boxes, .offsets = offsets, .half = true}, SP_OFFSETS);
    std::cout << list.size() << " pairs of " << offsets.back() << " points in " << boxes.size() << " systems\n";

    // Rows are sorted by the first point, so the rows of a system lie together.
    const int64_t of_first_system = list.offsets()[size_t(offsets[1])];
    const std::span first_points = std::span(positions).first(size_t(3 * offsets[1]));
    const int64_t alone = context.count({.positions = first_points, .cutoff = 1.5, .box = boxes[0], .half = true});
    std::cout << of_first_system << " pairs in the first system, " << alone << " where it is alone\n";
    return list.size() > 0 && alone == of_first_system ? 0 : 1;
  } catch (const spherepair::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
