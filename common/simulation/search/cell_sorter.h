// SPDX-License-Identifier: MIT
// The grid of a simulation: which cells the spheres have, and the spheres in the order of their cells.
#pragma once

#include "common/backend/plan_watch.h"
#include "common/device/context.h"

namespace spherepair {

class CellSorter {
 public:
  explicit CellSorter(DeviceContext& context) : context_(context) {}

  void upload(const Scene& scene);

  const GridPlans& plans() const { return plans_; }

  // Plans the cells anew where spheres may have left those of the last plan: reads some positions back, rarely.
  bool replan_if_needed();

  // Makes the cells that the options ask for current: the grid's part of the parameters, the table, the spheres in the
  // order of the cells, and their counts and totals cleared where `results_clear` says that they are not yet. What is
  // current already is kept.
  void build(const CollideOptions& options, bool equal_radii, bool results_clear);

  // The same for the light of an image: counts in cell order are lost where the search's cells would not do.
  void build_for_light();
  bool built_for_light() const { return built() && planned_ == Cells::dense && leveled_ == has_light_levels(); }

  bool built() const { return built_of_ == context_.moves; }            // for the spheres as they stand
  void forget_order() { built_of_.reset(); }                            // a search without cells came between
  bool dense() const { return planned_ == Cells::dense && !leveled_; }  // as searches have them
  Order order() const { return built() ? order_ : Order::scene; }       // in which the search finds the spheres
  uint indices(Order order) const;     // INDEX_IN_* of a launch that reads them in this order
  std::vector<uint> sphere_indices();  // by sorted index

 private:
  bool has_light_levels() const { return plans_.light.top_level != 0; }
  void plan_cells(const GridPlan& plan);
  bool stands_in_cell_order(const GridOptions& options);
  std::vector<vec4> sample_positions();
  void launch_bounds();

  DeviceContext& context_;
  GridPlans plans_;
  PlanWatch watch_;                   // whether they still fit
  std::optional<Cells> planned_;      // the cells that table and parameters are for
  bool leveled_ = false;              // these are plans_.light, in levels
  std::optional<bool> cell_order_;    // whether the spheres stood in cell order as they were when last looked at ...
  uint64_t looked_at_ = 0;            // ... after so many moves
  uint64_t moves_to_wait_ = 0;        // before that is looked at again
  uint64_t watched_ = 0;              // moves that the watch knows of
  std::optional<uint64_t> built_of_;  // these moves; none: not built
  Order order_ = Order::scene;
  bool index_in_w_ = false;  // of the spheres in cell order
};

}  // namespace spherepair
