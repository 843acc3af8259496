// SPDX-License-Identifier: MIT
// The search for colliding pairs on a device: chooses, launches and completes it, and reads results.
#pragma once

#include <set>
#include <utility>

#include "common/scene/scene_params.h"
#include "common/shared/contact/periodic.h"
#include "common/simulation/search/cell_sorter.h"

namespace spherepair {

class PairSearch {
 public:
  PairSearch(DeviceContext& context, CellSorter& sorter) : context_(context), sorter_(sorter) {}

  void upload(const Scene& scene);
  void make_room();                          // for as many spheres as the context says; results are lost
  void cleared() { results_clear_ = true; }  // another kernel cleared counts and totals
  void forget();                             // drops the results: other kernels overwrite them

  MethodChoice choice(const CollideOptions& options) const;

  // Launches a search of the spheres in SLOT_POSITION and returns. complete() does the rest: it decides the pairs that
  // the filter left undecided, lets short lists grow, and counts the colliding spheres. If the last complete search of
  // this kind had undecided pairs, they are decided here. in_step: a move has begun the device's step. A swept search
  // reads the pairs whose paths are near from SLOT_NEAR, and the velocities from SLOT_GROWN. In a periodic box a search
  // reads near pairs of spheres and images there.
  void enqueue(const CollideOptions& options, bool in_step = false);
  void require_options(const CollideOptions& options) const;  // throws std::invalid_argument naming what is impossible

  // Launches `steps` steps, each a move and a search of all pairs, as one kernel.
  void enqueue_steps(uint steps);

  // Completes the enqueued search: every pair is decided, every list has room, totals are read.
  void complete();

  // Searches the current positions; returns how many pairs SLOT_PAIR has, in any order. Reads no totals.
  uint64_t list_pairs(CollideOptions options);

  bool searched() const { return results() != Results::none; }  // the current positions
  bool is_complete() const { return results() == Results::complete; }
  const CollideOptions& options() const { return options_; }

  // Results of a complete search of the current positions; all throw BackendError if there is none.
  const Collisions& totals() const;
  std::vector<uint> counts();  // by sphere index
  std::vector<Pair> pairs();   // in canonical order; also throws if the search kept none

  bool counts_sorted() const { return counts_sorted_; }  // counts are in cell order
  bool results_clear() const { return results_clear_; }

  // For drawing: provides contact counts of the current positions, by sphere index or, if `sorted` allows it, in cell
  // order. Without a search the counts are 0.
  void prepare_counts(bool sorted);
  // Does the same by sphere index, before the spheres are sorted in another way.
  void leave_cells() { prepare_counts(false), order_ = Order::scene; }
  Order order() const { return searched() ? order_ : Order::scene; }  // of the results, while the cells exist

 private:
  enum class Results { none, enqueued, complete };
  Results results() const { return results_of_ == context_.moves ? results_ : Results::none; }  // of these positions
  void launched() { results_ = Results::enqueued, results_of_ = context_.moves; }

  void choose(const CollideOptions& options);
  void prepare_launch();
  void launch(bool in_step = false);
  void launch_grid(bool results_clear);
  void launch_near();
  bool of_near_pairs() const { return options_.swept || periodic_axes(context_.params.contact) != 0; }
  void set_params();
  void resolve_undecided();
  std::vector<uint> complete_lists();  // returns the summary
  std::vector<uint> read_summary();
  bool grow_lists(const std::vector<uint>& summary);
  void require_complete() const;
  std::pair<Method, bool> kind() const { return {options_.method, search_decides_}; }

  DeviceContext& context_;
  CellSorter& sorter_;
  std::array<SearchParams, 2> constants_{};  // of the scene; index: exact
  CollideOptions options_;                   // of the last search, with the chosen method and group size
  Variant variant_;
  Order order_ = Order::scene;  // of the results
  Results results_ = Results::none;
  uint64_t results_of_ = 0;      // moves at that search
  bool results_clear_ = false;   // counts and totals are 0
  bool counts_sorted_ = false;   // SLOT_COUNT lacks the counts that SLOT_SORTED_COUNT has
  bool search_decides_ = false;  // decides most undecided pairs itself, defers the rest
  bool resolved_ = true;         // deferred pairs are decided
  Collisions totals_;
  std::set<std::pair<Method, bool>> resolved_in_step_;  // kinds of search that decide deferred pairs in the step
};

}  // namespace spherepair
