// SPDX-License-Identifier: MIT
// Where the points of a list's problem are inside their boxes, and the images that the reach of others comes to.
#pragma once

#include "common/lists/list_systems.h"

namespace spherepair {

struct PointImage {
  uint32_t point, system;
  Shift shift;   // from the point inside the box
  Point3 place;  // rounded
};

class ListPlan {
 public:
  // Throws ListError if a box is flat, if a point lies too far outside its box, or if there are over 2^27 images.
  explicit ListPlan(const ListProblem& problem);

  // Points, and those that look for pairs (queries, or points), inside their boxes.
  const std::vector<Point3>& points() const { return open_ ? problem_.set.points : points_; }
  const std::vector<Point3>& looking() const {
    if (!problem_.asks) return points();
    return open_ ? problem_.queries.points : queries_;
  }
  // Of those that look.
  const PointSystems& systems() const { return problem_.asks ? query_systems_ : point_systems_; }
  const std::vector<System>& ranges() const { return ranges_; }
  const std::vector<Lattice>& lattices() const { return lattices_; }

  // By point, then by shift. Where points look for points, only those with a shift; else all.
  const std::vector<PointImage>& images() const { return images_; }
  bool is_open() const { return open_; }

  // S of the pair of `first` and the image of `second` by `shift`.
  Shift shift_of(uint32_t first, uint32_t second, const Shift& shift) const;
  void prefetch_cell(uint32_t point) const { cells_.prefetch(point); }

 private:
  struct Measured;
  Measured measured(const PointSet& set, const std::vector<Point3>& inside, const PointCells& cells, size_t b) const;
  void measure(size_t b);
  double reach_of(uint64_t point, const System& system) const;
  template <typename Add>
  void images_of(uint64_t point, Add add) const;
  void check_number_of_images() const;
  void add_images();

  const ListProblem& problem_;
  PointSystems point_systems_, query_systems_;
  std::vector<Lattice> lattices_;         // one a system
  bool open_ = true;                      // no box is periodic
  std::vector<Point3> points_, queries_;  // if one is
  PointCells cells_, query_cells_;
  std::vector<System> ranges_;
  std::vector<PointImage> images_;
};

}  // namespace spherepair
