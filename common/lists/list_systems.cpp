// SPDX-License-Identifier: MIT
#include "common/lists/list_systems.h"

#include <fmt/format.h>

#include <algorithm>

namespace spherepair {
namespace {

constexpr double most_cells = 0x1p30;  // away from the box: differences of two fit into 32 bits

}  // namespace

PointSystems::PointSystems(const PointSet& set) {
  if (set.offsets.size() <= 2) return;
  of_.resize(set.size());
  for (size_t b = 0; b + 1 < set.offsets.size(); ++b)
    std::fill(of_.begin() + int64_t(set.offsets[b]), of_.begin() + int64_t(set.offsets[b + 1]), uint32_t(b));
}

std::vector<Point3> wrapped(const PointSet& set, const char* name, const PointSystems& systems,
                            const std::vector<Lattice>& lattices, PointCells& cells) {
  std::vector<Point3> inside(set.points);
  cells.resize(set.size());
  int64_t far = -1;
#pragma omp parallel for schedule(static) reduction(max : far) if (int64_t(inside.size()) > share_from)
  for (int64_t i = 0; i < int64_t(inside.size()); ++i) {
    const Lattice& lattice = lattices[systems[i]];
    if (lattice.box().is_open()) continue;
    const Point3 at = lattice.fraction(inside[i]);
    Shift back;
    for (size_t k = 0; k < 3; ++k) {
      if (!(std::abs(at[k]) < most_cells))
        far = i;
      else
        cells.at(i)[k] = int32_t(std::floor(at[k]));
      back[k] = -cells.at(i)[k];
    }
    inside[i] = lattice.moved(inside[i], back);
  }
  if (far >= 0) throw too_far(name, uint64_t(far));
  return inside;
}

ListError too_far(const char* name, uint64_t i) {
  return {ListFault::range, fmt::format("{}[{}] lies more than 2^30 boxes away from the box at the origin", name, i)};
}

double radius_of(const ListProblem& problem, const PointSet& set, uint64_t i) {
  return (set.radii.empty() ? problem.cutoff / 2 : set.radii[i]) + problem.skin / 2;
}

}  // namespace spherepair
