// SPDX-License-Identifier: MIT
// Whether spheres that move may have left the cells that were planned for them. They would still be found, as spheres
// of the cells along the border, but these would fill up.
#pragma once

#include "common/backend/grid_plan.h"

namespace spherepair {

class PlanWatch {
 public:
  PlanWatch() = default;
  PlanWatch(const Scene& scene, const GridPlans& plans);

  void moved() { travelled_ += step_; }
  bool needed() const { return travelled_ > patience_ * allowance_; }

  // Whether some of the spheres, from all over the scene, show that new cells may pay: many stand outside the cells, or
  // the cells along some axis are mostly empty. If not, the watch is content for longer.
  bool worthwhile(const std::vector<vec4>& sample, const GridPlans& plans);

  // Plans anew for n spheres as such a sample stands; false, and the plans are kept, when nothing would change.
  bool replan(const std::vector<vec4>& sample, uint64_t n, GridPlans& plans);

 private:
  void allow(const GridPlans& plans);

  double step_ = 0;       // metres that the fastest sphere can go in a step
  double allowance_ = 1;  // metres that spheres may go before the cells at the border are fuller than the others
  double travelled_ = 0;
  double patience_ = 1;  // grows while there is nothing to change
};

}  // namespace spherepair
