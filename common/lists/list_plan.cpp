// SPDX-License-Identifier: MIT
#include "common/lists/list_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/backend/cpu_team.h"

namespace spherepair {
namespace {

constexpr double most_images = 0x1p27;  // as many spheres as OpenGL's buffers hold

[[noreturn]] void too_many_images(double images) {
  throw ListError(ListFault::range, fmt::format("the cutoff reaches over {:.3g} images of the points, but 2^27 at most "
                                                "can be searched: take a smaller cutoff",
                                                images));
}

}  // namespace

struct ListPlan::Measured {
  PointRange inside = {}, fractions = {};
  double radius = 0, radii = 0, least = INFINITY;  // the largest, their sum, the smallest
  double largest = 0;                              // of coordinates as given
  Point3 cells = {};                               // the farthest
  void add(const Measured& other) {
    inside.add(other.inside), fractions.add(other.fractions);
    least = std::min(least, other.least), radii += other.radii, radius = std::max(radius, other.radius),
    largest = std::max(largest, other.largest);
    for (size_t k = 0; k < 3; ++k) cells[k] = std::max(cells[k], other.cells[k]);
  }
};

ListPlan::ListPlan(const ListProblem& problem)
    : problem_(problem), point_systems_(problem.set), query_systems_(problem.queries) {
  lattices_.reserve(problem.boxes.size());
  for (size_t b = 0; b < problem.boxes.size(); ++b) lattices_.emplace_back(problem.boxes[b], b);
  open_ = std::ranges::all_of(lattices_, [](const Lattice& each) { return each.box().is_open(); });
  if (!open_) {
    points_ = wrapped(problem.set, "positions", point_systems_, lattices_, cells_);
    if (problem.asks) queries_ = wrapped(problem.queries, "queries", query_systems_, lattices_, query_cells_);
  }
  ranges_.resize(lattices_.size());
  const int64_t systems = int64_t(ranges_.size());
  in_shares(0, systems, systems > 1 ? int64_t(problem.set.size()) : 0, [&](int64_t begin, int64_t end) {
    for (int64_t b = begin; b < end; ++b) measure(size_t(b));
  });
  add_images();
}

Shift ListPlan::shift_of(uint32_t first, uint32_t second, const Shift& shift) const {
  if (open_) return shift;
  const Shift from = (problem_.asks ? query_cells_ : cells_)[first], to = cells_[second];
  return {shift[0] + from[0] - to[0], shift[1] + from[1] - to[1], shift[2] + from[2] - to[2]};
}

// Measures the points of system b in a set; inside: the set's wrapped points.
ListPlan::Measured ListPlan::measured(const PointSet& set, const std::vector<Point3>& inside, const PointCells& cells,
                                      size_t b) const {
  const Lattice& lattice = lattices_[b];
  const bool is_open = lattice.box().is_open();
  const auto first = int64_t(set.offsets[b]), last = int64_t(set.offsets[b + 1]);
  Measured all;
  const auto measure_share = [&](int64_t begin, int64_t end) {
    Measured own;
    for (int64_t i = begin; i < end; ++i) {
      own.inside.add(inside[i]);
      const double radius = radius_of(problem_, set, uint64_t(i));
      own.least = std::min(own.least, radius), own.radii += radius, own.radius = std::max(own.radius, radius);
      for (const double x : set.points[i]) own.largest = std::max(own.largest, std::abs(x));
      if (is_open) continue;
      own.fractions.add(lattice.fraction(inside[i]));
      const Shift cell = cells[i];
      for (size_t k = 0; k < 3; ++k) own.cells[k] = std::max(own.cells[k], std::abs(double(cell[k])));
    }
#pragma omp critical(measured_of_a_list)
    all.add(own);
  };
  in_shares(first, last, measure_share);
  return all;
}

void ListPlan::measure(size_t b) {
  const Lattice& lattice = lattices_[b];
  const Measured of_points = measured(problem_.set, points(), cells_, b);
  const Measured of_looking = problem_.asks ? measured(problem_.queries, looking(), query_cells_, b) : of_points;
  const auto mean_of = [&](const Measured& all, const PointSet& set) {
    return all.radii / std::max<double>(1, double(set.offsets[b + 1] - set.offsets[b]));
  };
  System& system = ranges_[b];
  system = {.inside = of_looking.inside,
            .fractions = of_looking.fractions,
            .reach = of_looking.radius + of_points.radius,
            .radius = of_looking.radius,
            .mean_reach = mean_of(of_looking, problem_.firsts()) + mean_of(of_points, problem_.set),
            .least = std::min(of_looking.least, of_points.least)};
  // What the box's rows add to a coordinate at most when a point is wrapped and moved to an image.
  double shifts = 0;
  const Point3 spans = lattice.spans(system.reach);
  for (size_t k = 0; k < 3; ++k)
    if (lattice.box().periodic[k]) {
      double edge = 0;
      for (const double x : lattice.box().rows[k]) edge = std::max(edge, std::abs(x));
      shifts += (std::max(of_points.cells[k], of_looking.cells[k]) + spans[k] + 2) * edge;
    }
  system.rounded = 0x1p-48 * (std::max(of_looking.largest, of_points.largest) + shifts);
}

// Upper bound of the distance at which an image of a point can be in a pair.
double ListPlan::reach_of(uint64_t point, const System& system) const {
  return (system.radius + radius_of(problem_, problem_.set, point)) * (1 + 0x1p-40) + 4 * system.rounded;
}

// Calls add(shift, place) for each image of a point that may be within reach of a point that looks for pairs.
template <typename Add>
void ListPlan::images_of(uint64_t point, Add add) const {
  const uint32_t b = point_systems_[point];
  const System& system = ranges_[b];
  if (system.inside.empty()) return;
  const Lattice& lattice = lattices_[b];
  const double reach = reach_of(point, system);
  const Point3 &inside = points()[point], at = lattice.fraction(inside), spans = lattice.spans(reach);
  Point3 lowest, highest;
  Shift low = {}, high = {};
  for (size_t k = 0; k < 3; ++k) {
    lowest[k] = system.inside.low[k] - reach, highest[k] = system.inside.high[k] + reach;
    if (!lattice.box().periodic[k]) continue;
    low[k] = ceil_of(system.fractions.low[k] - spans[k] - at[k]);
    high[k] = floor_of(system.fractions.high[k] + spans[k] - at[k]);
  }
  const auto is_near = [&](const Point3& place) {
    bool near = true;
    for (size_t k = 0; k < 3; ++k) near = near && place[k] >= lowest[k] && place[k] <= highest[k];
    return near;
  };
  for (Shift shift = low; shift[0] <= high[0]; ++shift[0])
    for (shift[1] = low[1]; shift[1] <= high[1]; ++shift[1])
      for (shift[2] = low[2]; shift[2] <= high[2]; ++shift[2]) {
        if (!problem_.asks && shift == Shift{}) continue;
        if (const Point3 place = lattice.moved(inside, shift); is_near(place)) add(shift, place);
      }
}

void ListPlan::check_number_of_images() const {
  double images = 0;
  for (size_t b = 0; b < ranges_.size(); ++b) {
    const Point3 spans = lattices_[b].spans(ranges_[b].reach);
    double each = 1;
    for (size_t k = 0; k < 3; ++k)
      if (lattices_[b].box().periodic[k])
        each *= ranges_[b].fractions.high[k] - ranges_[b].fractions.low[k] + 2 * spans[k] + 1;
    if (!ranges_[b].inside.empty()) images += each * double(problem_.set.offsets[b + 1] - problem_.set.offsets[b]);
  }
  if (images > 8 * most_images) too_many_images(images);
}

void ListPlan::add_images() {
  if (open_ && !problem_.asks) return;
  check_number_of_images();
  const auto add = [&](uint64_t first, uint64_t last, std::vector<PointImage>& images) {
    images.reserve(256);
    for (uint64_t i = first; i < last; ++i)
      images_of(i, [&](const Shift& shift, const Point3& place) {
        images.push_back({uint32_t(i), point_systems_[i], shift, place});
      });
  };
  constexpr uint64_t share = 4096;  // points
  const uint64_t count = problem_.set.size();
  const uint64_t shares = (count + share - 1) / share;
  std::vector<std::vector<PointImage>> parts(shares);
  TeamErrors errors;
  in_shares(0, int64_t(shares), int64_t(count), [&](int64_t begin, int64_t end) {
    for (auto k = uint64_t(begin); k < uint64_t(end); ++k)
      errors.run(k, [&] { add(k * share, std::min((k + 1) * share, count), parts[k]); });
  });
  errors.rethrow();
  for (auto& part : parts)
    if (images_.empty())
      images_ = std::move(part);
    else
      images_.insert(images_.end(), part.begin(), part.end());
  const double all = double(images_.size()) + double(problem_.firsts().size());
  if (all > most_images && !images_.empty() && !open_) too_many_images(all);
}

}  // namespace spherepair
