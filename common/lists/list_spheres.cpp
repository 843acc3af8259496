// SPDX-License-Identifier: MIT
#include "common/lists/list_spheres.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/backend/cpu_team.h"
#include "common/lists/list_systems.h"

namespace spherepair {
namespace {

constexpr double most_images = 0x1p27;  // as many spheres as OpenGL's buffers hold

class Planner {
 public:
  explicit Planner(const ListProblem& problem) : problem_(problem), plan_(problem), point_systems_(problem.set) {
    for (size_t b = 0; b < problem.boxes.size(); ++b) plan_.lattices.emplace_back(problem.boxes[b], b);
    open_ = std::ranges::all_of(plan_.lattices, [](const Lattice& each) { return each.box().is_open(); });
    if (!open_) {
      points_ = wrapped(problem.set, "positions", point_systems_, plan_.lattices, plan_.cells);
      if (problem.asks)
        queries_ = wrapped(problem.queries, "queries", plan_.systems, plan_.lattices, plan_.first_cells);
      else
        plan_.first_cells = plan_.cells;
    }
    measure_systems();
    add_images();
    place();
  }
  ListSpheres take() { return std::move(plan_); }

 private:
  // Wrapped into their boxes.
  const std::vector<Point3>& points() const { return open_ ? problem_.set.points : points_; }
  const std::vector<Point3>& looking() const {
    if (!problem_.asks) return points();
    return open_ ? problem_.queries.points : queries_;
  }

  struct Measured {
    PointRange inside = {}, fractions = {};
    double radius = 0, largest = 0;  // of coordinates as given
    void add(const Measured& other) {
      inside.add(other.inside), fractions.add(other.fractions);
      radius = std::max(radius, other.radius), largest = std::max(largest, other.largest);
    }
  };
  // Measures the points of system b in a set; inside: the set's wrapped points.
  Measured measured(const PointSet& set, const std::vector<Point3>& inside, size_t b) const {
    const Lattice& lattice = plan_.lattices[b];
    const auto first = int64_t(set.offsets[b]), last = int64_t(set.offsets[b + 1]);
    Measured all;
#pragma omp parallel if (last - first > share_from)
    {
      Measured own;
#pragma omp for schedule(static) nowait
      for (int64_t i = first; i < last; ++i) {
        own.inside.add(inside[i]);
        if (!lattice.box().is_open()) own.fractions.add(lattice.fraction(inside[i]));
        own.radius = std::max(own.radius, radius_of(problem_, set, uint64_t(i)));
        for (const double x : set.points[i]) own.largest = std::max(own.largest, std::abs(x));
      }
#pragma omp critical(measured_of_a_list)
      all.add(own);
    }
    return all;
  }

  void measure_systems() {
    systems_.resize(plan_.lattices.size());
    for (size_t b = 0; b < systems_.size(); ++b) {
      const Measured of_looking = measured(problem_.firsts(), looking(), b);
      const Measured of_points = problem_.asks ? measured(problem_.set, points(), b) : of_looking;
      systems_[b] = {.inside = of_looking.inside,
                     .fractions = of_looking.fractions,
                     .reach = of_looking.radius + of_points.radius,
                     .radius = of_looking.radius};
      systems_[b].rounded = 0x1p-48 * (std::max(of_looking.largest, of_points.largest) + size_of_shifts(b));
    }
  }

  // Upper bound of what the box's rows add to a coordinate when a point is wrapped and moved to an image.
  double size_of_shifts(size_t b) const {
    const Lattice& lattice = plan_.lattices[b];
    const Point3 spans = lattice.spans(systems_[b].reach);
    Point3 cells = {};
    if (lattice.box().is_open()) return 0;
    const auto farthest = [&](const PointCells& all, const std::vector<uint64_t>& offsets) {
      for (uint64_t i = offsets[b]; i < offsets[b + 1]; ++i)
        for (size_t k = 0; k < 3; ++k) cells[k] = std::max(cells[k], std::abs(double(all[i][k])));
    };
    farthest(plan_.cells, problem_.set.offsets);
    farthest(plan_.first_cells, problem_.firsts().offsets);
    double size = 0;
    for (size_t k = 0; k < 3; ++k)
      if (lattice.box().periodic[k]) {
        double edge = 0;
        for (const double x : lattice.box().rows[k]) edge = std::max(edge, std::abs(x));
        size += (cells[k] + spans[k] + 2) * edge;
      }
    return size;
  }

  // Upper bound of the distance at which an image of a point can be in a pair.
  double reach_of(uint64_t point, const System& system) const {
    return (system.radius + radius_of(problem_, problem_.set, point)) * (1 + 0x1p-40) + 4 * system.rounded;
  }

  // Calls add(shift, place) for each image of a point that may be within reach of a point that looks for pairs.
  template <typename Add>
  void images_of(uint64_t point, Add add) const {
    const uint32_t b = point_systems_[point];
    const System& system = systems_[b];
    if (system.inside.empty()) return;
    const Lattice& lattice = plan_.lattices[b];
    const double reach = reach_of(point, system);
    const Point3 at = lattice.fraction(points()[point]), spans = lattice.spans(reach);
    Shift low = {}, high = {};
    for (size_t k = 0; k < 3; ++k)
      if (lattice.box().periodic[k]) {
        low[k] = int32_t(std::ceil(system.fractions.low[k] - spans[k] - at[k]));
        high[k] = int32_t(std::floor(system.fractions.high[k] + spans[k] - at[k]));
      }
    for (Shift shift = low; shift[0] <= high[0]; ++shift[0])
      for (shift[1] = low[1]; shift[1] <= high[1]; ++shift[1])
        for (shift[2] = low[2]; shift[2] <= high[2]; ++shift[2]) {
          if (!problem_.asks && shift == Shift{}) continue;
          const Point3 place = lattice.moved(points()[point], shift);
          bool near = true;
          for (size_t axis = 0; axis < 3; ++axis)
            near &= place[axis] >= system.inside.low[axis] - reach && place[axis] <= system.inside.high[axis] + reach;
          if (near) add(shift, place);
        }
  }

  void check_number_of_images() const {
    double images = 0;
    for (size_t b = 0; b < systems_.size(); ++b) {
      const Point3 spans = plan_.lattices[b].spans(systems_[b].reach);
      double each = 1;
      for (size_t k = 0; k < 3; ++k)
        if (plan_.lattices[b].box().periodic[k])
          each *= systems_[b].fractions.high[k] - systems_[b].fractions.low[k] + 2 * spans[k] + 1;
      if (!systems_[b].inside.empty()) images += each * double(problem_.set.offsets[b + 1] - problem_.set.offsets[b]);
    }
    if (images > 8 * most_images) too_many_images(images);
  }

  [[noreturn]] static void too_many_images(double images) {
    throw ListError(ListFault::range,
                    fmt::format("the cutoff reaches over {:.3g} images of the points, but 2^27 at most "
                                "can be searched: take a smaller cutoff",
                                images));
  }

  void add_images() {
    if (open_ && !problem_.asks) return;
    check_number_of_images();
    constexpr uint64_t share = 4096;  // points
    const uint64_t count = problem_.set.size();
    const auto shares = int64_t((count + share - 1) / share);
    std::vector<std::vector<PointImage>> images(shares);
    std::vector<std::vector<Point3>> places(shares);
    TeamErrors errors;
#pragma omp parallel for schedule(dynamic, 1) if (shares > 1)
    for (int64_t k = 0; k < shares; ++k)
      errors.run(uint64_t(k), [&] {
        for (uint64_t i = uint64_t(k) * share; i < std::min((uint64_t(k) + 1) * share, count); ++i)
          images_of(i, [&](const Shift& shift, const Point3& place) {
            images[k].push_back({uint32_t(i), point_systems_[i], shift}), places[k].push_back(place);
          });
      });
    errors.rethrow();
    for (int64_t k = 0; k < shares; ++k) {
      plan_.images.insert(plan_.images.end(), images[k].begin(), images[k].end());
      places_.insert(places_.end(), places[k].begin(), places[k].end());
    }
    const double all = double(plan_.images.size()) + double(plan_.looking);
    if (all > most_images && double(plan_.images.size()) > 0 && !open_) too_many_images(all);
  }

  // Places the systems in a cubic grid around 0 whose edge is 1 at most: float32 then moves a coordinate by 2^-26 at
  // most, a centre by less than 2^-25.
  void place() {
    double pitch = 0;
    for (const System& system : systems_)
      if (!system.inside.empty())
        for (size_t axis = 0; axis < 3; ++axis)
          pitch = std::max(pitch,
                           system.inside.high[axis] - system.inside.low[axis] + 3 * system.reach + 16 * system.rounded);
    const uint64_t side = uint64_t(std::ceil(std::cbrt(double(systems_.size()))));
    const double all = pitch * double(side), scale = all > 0 ? std::exp2(-std::ceil(std::log2(all))) : 1;
    const auto sphere = [&](const Point3& at, uint32_t b, double radius) {
      const System& system = systems_[b];
      const uint64_t cell[3] = {b % side, b / side % side, b / side / side};
      float centre[3];
      for (size_t axis = 0; axis < 3; ++axis) {
        const double middle = system.inside.low[axis] / 2 + system.inside.high[axis] / 2;
        centre[axis] = float((at[axis] - middle + (double(cell[axis]) - double(side - 1) / 2) * pitch) * scale);
      }
      const double larger = (radius + 4 * system.rounded) * scale * (1 + 0x1p-40) + 0x1p-25;
      return vec4{centre[0], centre[1], centre[2], std::nextafter(float(larger), INFINITY)};
    };
    const int64_t looking_count = int64_t(plan_.looking);
    plan_.spheres.resize(plan_.looking + plan_.images.size());
#pragma omp parallel for schedule(static) if (int64_t(plan_.spheres.size()) > share_from)
    for (int64_t i = 0; i < int64_t(plan_.spheres.size()); ++i) {
      if (i < looking_count) {
        plan_.spheres[i] = sphere(looking()[i], plan_.systems[i], radius_of(problem_, problem_.firsts(), uint64_t(i)));
        continue;
      }
      const PointImage& image = plan_.images[i - looking_count];
      plan_.spheres[i] =
          sphere(places_[i - looking_count], image.system, radius_of(problem_, problem_.set, image.point));
    }
  }

  const ListProblem& problem_;
  ListSpheres plan_;
  PointSystems point_systems_;
  bool open_ = true;                               // no box is periodic
  std::vector<Point3> points_, queries_, places_;  // inside periodic boxes; of images
  std::vector<System> systems_;
};

}  // namespace

ListSpheres list_spheres(const ListProblem& problem) { return Planner(problem).take(); }

}  // namespace spherepair
