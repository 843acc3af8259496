// SPDX-License-Identifier: MIT
// The grid of a simulation: the cells, and the spheres in cell order.
#pragma once

#include "common/device/context.h"
#include "common/plan/plan_watch.h"

namespace spherepair {

class CellSorter {
 public:
  explicit CellSorter(DeviceContext& context) : context_(context) {}

  void upload(const Scene& scene);

  const GridPlans& plans() const { return plans_; }

  // Plans new cells if spheres may have left the planned ones. It then reads some positions back, which is rare.
  bool replan_if_needed();

  // Makes the cells that the options ask for current: the grid's part of the parameters, the table, and the spheres in
  // cell order. Clears counts and totals unless `results_clear` says that they are clear. Keeps what is current
  // already.
  void build(const CollideOptions& options, bool equal_radii, bool results_clear);

  // Does the same for the light of an image. Counts in cell order are lost if the search's cells cannot be used.
  void build_for_light();
  bool built_for_light() const { return built() && planned_ == Cells::dense && leveled_ == has_light_levels(); }

  bool built() const { return built_of_ == context_.moves; }            // current cells exist
  void forget_order() { built_of_.reset(); }                            // a search without cells came between
  bool dense() const { return planned_ == Cells::dense && !leveled_; }  // cells of the kind that searches use
  Order order() const { return built() ? order_ : Order::scene; }       // of the spheres that the search reads
  uint indices(Order order) const;                                      // INDEX_IN_* of a launch with this order
  std::vector<uint> sphere_indices();                                   // by sorted index

 private:
  bool has_light_levels() const { return plans_.light.top_level != 0; }
  void plan_cells(const GridPlan& plan);
  bool stands_in_cell_order(const GridOptions& options);
  std::vector<vec4> sample_positions();
  void launch_bounds();

  DeviceContext& context_;
  GridPlans plans_;
  PlanWatch watch_;                   // whether the plans still fit
  std::optional<Cells> planned_;      // cells that table and parameters are for
  bool leveled_ = false;              // those are plans_.light, in levels
  std::optional<bool> cell_order_;    // whether spheres were in cell order when last checked ...
  uint64_t looked_at_ = 0;            // ... after so many moves
  uint64_t moves_to_wait_ = 0;        // moves before the next check
  uint64_t watched_ = 0;              // moves that the watch has counted
  std::optional<uint64_t> built_of_;  // moves at the last build; none: not built
  Order order_ = Order::scene;
  bool index_in_w_ = false;  // sphere indices are in w of the sorted spheres
};

}  // namespace spherepair
