// SPDX-License-Identifier: MIT
// The CPU's search for colliding pairs: chooses the method, keeps cells while they are current, and keeps the results.
#pragma once

#include <optional>

#include "common/backend/motion.h"
#include "common/cpu/search/cpu_grid.h"
#include "common/plan/plan_watch.h"
#include "common/scene/scene_params.h"

namespace spherepair {

class CpuSearch {
 public:
  CpuSearch(const BackendInfo& info, int threads) : info_(info), threads_(threads) {}

  void upload(const Scene& scene);
  void moved();

  MethodChoice choice(const CollideOptions& options) const;
  // Chooses the method for these positions. Plans new cells first if spheres have left the old ones.
  Method prepare(const CollideOptions& options, const std::vector<vec4>& positions);
  // Runs the prepared search. Only a swept search needs `state` and `saved`.
  void run(const std::vector<vec4>& positions, const Motion::State& state = {}, const MotionState& saved = {});

  // Decides these near pairs instead, in the scene's periodic box.
  void run_images(const std::vector<vec4>& positions, std::span<const Pair> near);

  // Returns the colliding pairs of these positions, in any order.
  const std::vector<Pair>& list_pairs(const std::vector<vec4>& positions,
                                      CollideOptions options = {.method = Method::automatic});

  bool searched() const { return found_.has_value(); }  // the current positions
  const Collisions& totals() const { return found().totals; }
  std::vector<uint> counts() const;
  const std::vector<Pair>& pairs() const;

  // Returns the parameters with the cells that an image's light uses.
  Params light_cells() const;
  const WorkCounts& work() const { return work_; }

 private:
  const PairsFound& found() const;
  SearchInput begin_run(const std::vector<vec4>& positions);
  void replan_if_needed(const std::vector<vec4>& positions, const CollideOptions& options);
  PairsFound search_cells(const SearchInput& input);

  const BackendInfo& info_;
  int threads_;
  uint64_t n_ = 0;
  bool equal_radii_ = true;  // of the scene
  MotionOptions motion_;
  Params params_{};
  std::array<SearchParams, 2> constants_{};  // of the scene; index: exact
  GridPlans plans_;
  PlanWatch watch_;
  WorkCounts work_;
  CpuGrid grid_;
  std::optional<Cells> cells_;       // the cells in grid_, if they hold the current positions ...
  bool cells_equal_radii_ = true;    // ... and whether they were sorted for equal radii
  CollideOptions options_;           // of the last search, with the chosen method
  std::optional<PairsFound> found_;  // by the last search
};

}  // namespace spherepair
