// SPDX-License-Identifier: MIT
//
// Contacts in C++: 64 spheres fall into a closed box and push each other, for half a second.
// Prints the time, the height of the highest sphere and the number of overlaps on the way.
#include <algorithm>
#include <iostream>
#include <spherepair/simulation.hpp>
#include <vector>

int main() {
  std::vector<std::array<double, 3>> positions;
  for (int n = 0; n < 64; ++n)
    positions.push_back({0.3 + 0.3 * (n % 4) + 0.01 * (n % 7), 0.3 + 0.3 * (n / 16), 0.3 + 0.3 * (n / 4 % 4)});
  const std::vector<double> radii(positions.size(), 0.1);

  try {
    spherepair::Simulation simulation({.positions = positions,
                                       .radii = radii,
                                       .restitution = 0.5,
                                       .contact = "spring",
                                       .walls = spherepair::Walls{{0, 0, 0}, {1.6, 1.6, 1.6}}},
                                      "cpu");
    double highest = 0;
    while (double(simulation.steps()) * simulation.dt() < 0.5) {
      simulation.move(uint64_t(0.1 / simulation.dt()) + 1);
      const auto [at, velocities] = simulation.state();
      highest = std::ranges::max(at, {}, [](const auto& centre) { return centre[1]; })[1];
      std::cout << double(simulation.steps()) * simulation.dt() << " s: up to " << highest << " m, "
                << simulation.pairs().size() << " overlaps\n";
    }
    return highest > 0.1 && highest < 1.2 ? 0 : 1;
  } catch (const spherepair::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
