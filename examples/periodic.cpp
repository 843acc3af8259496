// SPDX-License-Identifier: MIT
//
// A periodic box in C++: two points, 0.4 apart across a face of a tilted box that is periodic along x and y.
// Prints the pairs within a cutoff of 1.2, with the image of the second point and the vector to it. The box is 1 long
// in x, so that each point is also a neighbour of its own images. Then it fills arrays of its own with the same list.
#include <array>
#include <iostream>
#include <spherepair/spherepair.hpp>
#include <vector>

int main() {
  spherepair::Box box;
  box.rows = {{{1, 0, 0}, {0.5, 4, 0}, {0, 0, 0}}};  // a row of zeros: z is open
  box.periodic = {true, true, false};
  const std::vector<float> positions = {0.5F, 0.25F, 0, 0, 3.85F, 0};  // x, y, z of one point after another
  const spherepair::Problem problem{.positions = positions, .cutoff = 1.2, .box = box};

  try {
    spherepair::Context context("cpu");
    const auto list = context.list(problem, SP_SHIFTS | SP_VECTORS);
    for (size_t k = 0; k < list.first().size(); ++k) {
      const auto& [a, b, c] = list.shifts()[k];
      const auto& [x, y, z] = list.vectors()[k];
      std::cout << list.first()[k] << " -> " << list.second()[k] << " image " << a << ' ' << b << ' ' << c << ": " << x
                << ' ' << y << ' ' << z << '\n';
    }

    std::vector<int32_t> first(2), second(2);
    try {
      context.fill(problem, {.first = first, .second = second});
    } catch (const spherepair::CapacityError& error) {
      std::cout << "arrays of 2 rows are too short for " << error.needed() << " pairs\n";
      first.resize(size_t(error.needed()));
      second.resize(size_t(error.needed()));
    }
    const int64_t filled = context.fill(problem, {.first = first, .second = second});
    return filled == list.size() && filled == 10 && second.back() == list.second().back() ? 0 : 1;
  } catch (const spherepair::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
