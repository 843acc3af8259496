// SPDX-License-Identifier: MIT
#include "bench/lists/listed_spheres.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {

ListProblem problem_of(const PeriodicSpheres& spheres, std::optional<double> cutoff, bool full) {
  ListProblem problem{.set = spheres.set, .queries = {}, .boxes = {spheres.box}, .exclusions = {}};
  problem.half = !full;
  if (cutoff) {
    problem.cutoff = *cutoff;
    problem.inclusive = true;
    problem.set.radii.clear();
  }
  return problem;
}

ListedSpheres find_listed(Search& search, const SphereFile& input, std::optional<double> cutoff, bool full,
                          const CollideOptions& how) {
  const ListProblem problem = problem_of(*input.periodic, cutoff, full);
  ListedSpheres found;
  try {
    found.pairs = list_pairs(search, problem, how);
  } catch (const ListError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", input.file, error.what()));
  }
  found.counts.resize(problem.set.size());
  std::vector<Pair> ids;
  for (const auto& [first, second, shift] : found.pairs) {
    ++found.counts[first];
    if (problem.half) ++found.counts[second];
    if (first < second || (first == second && shift > Shift{})) ids.push_back({first, second});
  }
  found.totals.pairs = ids.size();
  found.totals.colliding_spheres = found.counts.size() - size_t(std::ranges::count(found.counts, 0u));
  found.totals.fingerprint = fingerprint(ids);
  return found;
}

}  // namespace spherepair
