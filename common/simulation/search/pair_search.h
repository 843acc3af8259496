// SPDX-License-Identifier: MIT
// The search for colliding pairs on a device: chooses and launches it, decides what its filter left, and reads results.
#pragma once

#include <set>
#include <utility>

#include "common/scene/scene_params.h"
#include "common/simulation/search/cell_sorter.h"

namespace spherepair {

class PairSearch {
 public:
  PairSearch(DeviceContext& context, CellSorter& sorter) : context_(context), sorter_(sorter) {}

  void upload(const Scene& scene);
  void cleared() { results_clear_ = true; }  // counts and totals, by another kernel
  void forget();                             // the results: other kernels write where they stand

  MethodChoice choice(const CollideOptions& options) const;

  // Launches a search of the spheres in SLOT_POSITION and returns. `complete` does the rest: it decides the pairs that
  // the filter left undecided, lets short lists grow, and counts the colliding spheres. The undecided pairs are decided
  // here if the last complete search of this kind had some. in_step: a move has begun the device's step. A swept search
  // reads the pairs whose paths are near from SLOT_NEAR, and the velocities from SLOT_GROWN.
  void enqueue(const CollideOptions& options, bool in_step = false);
  void require_options(const CollideOptions& options) const;  // std::invalid_argument names what cannot be

  // Launches so many steps of a move and a search of all pairs as one kernel.
  void enqueue_steps(uint steps);

  // Completes the search that was enqueued: every pair is decided, every list has room, totals are read.
  void complete();

  // Searches these positions for pairs and returns how many SLOT_PAIR has, in any order; no totals.
  uint64_t list_pairs(CollideOptions options);

  bool searched() const { return results() != Results::none; }  // these positions
  bool is_complete() const { return results() == Results::complete; }
  const CollideOptions& options() const { return options_; }

  // Of a complete search of these positions; BackendError where there is none.
  const Collisions& totals() const;
  std::vector<uint> counts();  // by sphere index
  std::vector<Pair> pairs();   // in canonical order; BackendError where the search kept none

  bool counts_sorted() const { return counts_sorted_; }  // they stand in cell order
  bool results_clear() const { return results_clear_; }

  // For drawing: contact counts of these positions, by sphere index unless `sorted` will do; 0 without a search.
  void prepare_counts(bool sorted);
  // The same, by sphere index for good, since the spheres are about to be sorted otherwise.
  void leave_cells() { prepare_counts(false), order_ = Order::scene; }
  Order order() const { return searched() ? order_ : Order::scene; }  // of the results, if the cells are still there

 private:
  enum class Results { none, enqueued, complete };
  Results results() const { return results_of_ == context_.moves ? results_ : Results::none; }  // of these positions
  void launched() { results_ = Results::enqueued, results_of_ = context_.moves; }

  void choose(const CollideOptions& options);
  void prepare_launch();
  void launch(bool in_step = false);
  void launch_grid(bool results_clear);
  void launch_swept();
  void set_params();
  void resolve_undecided();
  std::vector<uint> complete_lists();  // the summary
  std::vector<uint> read_summary();
  bool grow_lists(const std::vector<uint>& summary);
  void require_complete() const;
  std::pair<Method, bool> kind() const { return {options_.method, search_decides_}; }

  DeviceContext& context_;
  CellSorter& sorter_;
  std::array<SearchParams, 2> constants_{};  // of the scene: [exact]
  CollideOptions options_;                   // of the last search, method and group size as chosen
  Variant variant_;
  Order order_ = Order::scene;  // of its results
  Results results_ = Results::none;
  uint64_t results_of_ = 0;      // these moves
  bool results_clear_ = false;   // counts and totals are 0
  bool counts_sorted_ = false;   // SLOT_COUNT lacks the counts that SLOT_SORTED_COUNT has
  bool search_decides_ = false;  // most pairs that the filter leaves undecided, and defers only what is left
  bool resolved_ = true;         // what was deferred
  Collisions totals_;
  std::set<std::pair<Method, bool>> resolved_in_step_;  // kinds of search whose deferred pairs are decided in the step
};

}  // namespace spherepair
