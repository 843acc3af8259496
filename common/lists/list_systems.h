// SPDX-License-Identifier: MIT
// The systems of a problem: where their points are, inside their boxes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "common/lists/displacement.h"
#include "common/lists/lattice.h"

namespace spherepair {

constexpr int64_t share_from = 1 << 14;  // points from which on several threads share the work

// Runs work(begin, end), which may not throw, for shares of the numbers from `first` to before `last`. If there are
// few, or little work, they are one share without OpenMP, whose regions cost half a microsecond each.
template <typename Work>
void in_shares(int64_t first, int64_t last, int64_t items, Work work) {
  if (items <= share_from) return work(first, last);
  const int64_t share = std::clamp<int64_t>((last - first) / 64, 1, 1 << 12);
#pragma omp parallel for schedule(static)
  for (int64_t begin = first; begin < last; begin += share) work(begin, std::min(begin + share, last));
}
template <typename Work>
void in_shares(int64_t first, int64_t last, Work work) {
  in_shares(first, last, last - first, work);
}

struct PointRange {
  Point3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
  void add(const Point3& point) { add({point, point}); }
  void add(const PointRange& other) {
    for (size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], other.low[k]), high[k] = std::max(high[k], other.high[k]);
  }
  bool empty() const { return low[0] > high[0]; }
};

// The system of each point of a set; nothing is stored for a single system.
class PointSystems {
 public:
  explicit PointSystems(const PointSet& set);
  uint32_t operator[](uint64_t point) const { return of_.empty() ? 0 : of_[point]; }

 private:
  std::vector<uint32_t> of_;
};

// The cell of each point: x = inside + cell H. Nothing is stored if no box is periodic.
class PointCells {
 public:
  void resize(uint64_t points) { of_.resize(points); }
  Shift operator[](uint64_t point) const { return of_.empty() ? Shift{} : of_[point]; }
  Shift& at(uint64_t point) { return of_[point]; }
  void prefetch(uint64_t point) const {
    if (!of_.empty()) __builtin_prefetch(&of_[point]);
  }

 private:
  std::vector<Shift> of_;
};

// A system: the ranges of the points that look for pairs, and their reach.
struct System {
  PointRange inside, fractions;
  double reach = 0;   // of the two largest spheres
  double radius = 0;  // the largest that looks
  double mean_reach = 0;
  double least = 0;    // the smallest radius
  double rounded = 0;  // how far a coordinate of an image can be from its real number
};

// The points inside their boxes, and their cells. Throws ListError for a point too far away; `name` is the set's.
std::vector<Point3> wrapped(const PointSet& set, const char* name, const PointSystems& systems,
                            const std::vector<Lattice>& lattices, PointCells& cells);

// Of a point of the set with that name.
ListError too_far(const char* name, uint64_t i);

// The median of some of the points, axis by axis: it is among most of them, whatever lies far out.
Point3 middle_of(std::span<const Point3> points);

// The pairs to leave out.
class Exclusions {
 public:
  explicit Exclusions(const ListProblem& problem);
  bool empty() const { return pairs_.empty(); }
  bool has(const ListedPair& pair) const;

 private:
  const bool ordered_;  // of query and point; else in either order
  std::vector<std::array<uint32_t, 2>> pairs_;
};

// A point's share of the reach.
inline double radius_of(const ListProblem& problem, const PointSet& set, uint64_t i) {
  return (set.radii.empty() ? problem.cutoff / 2 : set.radii[i]) + problem.skin / 2;
}

}  // namespace spherepair
