// SPDX-License-Identifier: MIT
#include "common/lists/list_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

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
  std::atomic<int64_t> far = -1;
  in_shares(0, int64_t(inside.size()), [&](int64_t begin, int64_t end) {
    for (int64_t i = begin; i < end; ++i) {
      const Lattice& lattice = lattices[systems[i]];
      if (lattice.box().is_open()) continue;
      const Point3 at = lattice.fraction(inside[i]);
      Shift back;
      for (size_t k = 0; k < 3; ++k) {
        if (!(std::abs(at[k]) < most_cells))
          for (int64_t last = far; last < i && !far.compare_exchange_weak(last, i);) {
          }
        else
          cells.at(i)[k] = floor_of(at[k]);
        back[k] = -cells.at(i)[k];
      }
      inside[i] = lattice.moved(inside[i], back);
    }
  });
  if (far >= 0) throw too_far(name, uint64_t(far.load()));
  return inside;
}

ListError too_far(const char* name, uint64_t i) {
  return {ListFault::range, fmt::format("{}[{}] lies more than 2^30 boxes away from the box at the origin", name, i)};
}

Point3 middle_of(std::span<const Point3> points) {
  Point3 middle = {};
  for (size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
    std::vector<double> some;
    for (size_t i = 0; i < points.size(); i += points.size() / 512 + 1) some.push_back(points[i][axis]);
    const auto half = some.begin() + int64_t(some.size() / 2);
    std::ranges::nth_element(some, half);
    middle[axis] = *half;
  }
  return middle;
}

Exclusions::Exclusions(const ListProblem& problem) : ordered_(problem.asks), pairs_(problem.exclusions) {
  for (auto& [first, second] : pairs_)
    if (!ordered_ && first > second) std::swap(first, second);
  std::ranges::sort(pairs_);
}

bool Exclusions::has(const ListedPair& pair) const {
  if (pairs_.empty()) return false;
  std::array<uint32_t, 2> ids = {pair.first, pair.second};
  if (!ordered_ && ids[0] > ids[1]) std::swap(ids[0], ids[1]);
  return std::ranges::binary_search(pairs_, ids);
}

}  // namespace spherepair
