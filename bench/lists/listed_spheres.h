// SPDX-License-Identifier: MIT
// Finds the pairs of a file's spheres in a periodic box, decided by the file's own numbers.
#pragma once

#include "bench/spheres/sphere_file.h"
#include "common/lists/pair_list.h"

namespace spherepair {

// The problem of a half or full list. With a cutoff: points at most that far apart; else spheres that overlap.
ListProblem problem_of(const PeriodicSpheres& spheres, std::optional<double> cutoff, bool full);

struct ListedSpheres {
  Collisions totals;         // each pair counts once
  std::vector<uint> counts;  // neighbours of each sphere, images included
  std::vector<ListedPair> pairs;
};

// Throws std::invalid_argument that names the file.
ListedSpheres find_listed(Search& search, const SphereFile& input, std::optional<double> cutoff, bool full,
                          const CollideOptions& how);

}  // namespace spherepair
