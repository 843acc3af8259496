// SPDX-License-Identifier: MIT
// Watches whether moving spheres may have left the cells that were planned for them. The search would still find them,
// in the cells along the border, but these would fill up.
#pragma once

#include "common/plan/grid_plan.h"

namespace spherepair {

class PlanWatch {
 public:
  PlanWatch() = default;
  PlanWatch(const Scene& scene, const GridPlans& plans);

  void moved() { travelled_ += step_; }
  bool needed() const { return travelled_ > patience_ * allowance_; }

  // Whether a sample from all over the scene shows that new cells may pay: many spheres are outside the cells, or the
  // cells along some axis are mostly empty. If not, the watch waits longer before it asks again.
  bool worthwhile(const std::vector<vec4>& sample, const GridPlans& plans);

  // Plans anew for n spheres from such a sample. Returns false, and keeps the plans, if they would hardly change.
  bool replan(const std::vector<vec4>& sample, uint64_t n, GridPlans& plans);

 private:
  void allow(const GridPlans& plans);

  double step_ = 0;       // metres that the fastest sphere can travel in a step
  double allowance_ = 1;  // metres that spheres may travel before the cells at the border are fuller than the others
  double travelled_ = 0;
  double patience_ = 1;  // multiplies the allowance; grows while plans stay as they are
};

}  // namespace spherepair
