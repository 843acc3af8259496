// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_search.h"

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/backend/swept_paths.h"
#include "common/scene/contact_scene.h"

namespace spherepair {

void CpuSearch::upload(const Scene& scene) {
  n_ = scene.size();
  equal_radii_ = scene.equal_radii;
  params_ = {};
  motion_ = scene.motion;
  params_.motion = motion_params(scene);
  params_.contact = contact_params(scene);
  params_.n = uint(scene.size());
  params_.radius = common_radius(scene);
  constants_ = {search_params(scene, false), search_params(scene, true)};
  plans_ = plan_grids(scene.positions);
  watch_ = PlanWatch(scene, plans_);
  work_ = {.plans = 1};
  cells_.reset();
  found_.reset();
}

void CpuSearch::moved() {
  watch_.moved();
  cells_.reset();
  found_.reset();
}

MethodChoice CpuSearch::choice(const CollideOptions& options) const {
  return explain_choice(info_, n_, plans_, options);
}

void CpuSearch::replan_if_needed(const std::vector<vec4>& positions, const CollideOptions& options) {
  const bool may_use_grid = options.method == Method::collide_grid || options.method == Method::automatic;
  if (!options.grid.replan || !may_use_grid || !watch_.needed()) return;
  if (!watch_.replan(positions, positions.size(), plans_)) return;
  ++work_.plans;
  cells_.reset();
}

PairsFound CpuSearch::search_cells(const SearchInput& input) {
  const GridPlan& plan = plans_.plan(input.options.grid.cells);
  const bool keep = input.options.grid.keep_cells && cells_ == plan.cells && cells_equal_radii_ == input.equal_radii;
  ++(keep ? work_.cells_kept : work_.sorts);
  cells_.reset();  // stays empty if the sort fails
  PairsFound found = grid_.search(input, plan, keep);
  cells_equal_radii_ = input.equal_radii;
  cells_ = plan.cells;
  return found;
}

Method CpuSearch::prepare(const CollideOptions& options, const std::vector<vec4>& positions) {
  check_collide(options);
  refuse_missing(info_.name, options, {}, false);
  refuse_tensor(info_.name, options, false);
  replan_if_needed(positions, options);
  options_ = options;
  options_.method = chosen_method(info_, n_, plans_, options);
  return options_.method;
}

SearchInput CpuSearch::begin_run(const std::vector<vec4>& positions) {
  params_.search = constants_[options_.exact];
  if (!options_.filter) leave_all_undecided(params_.search);
  const bool equal_radii = equal_radii_ && !options_.load_radii;
  ++work_.steps;
  work_.without_radii += equal_radii;
  work_.lists += options_.want_pairs;
  found_.reset();
  return {positions, params_, equal_radii, options_, threads_};
}

void CpuSearch::run_images(const std::vector<vec4>& positions, std::span<const Pair> near) {
  found_ = search_images(begin_run(positions), near);
}

void CpuSearch::run(const std::vector<vec4>& positions, const Motion::State& state, const MotionState& saved) {
  const SearchInput input = begin_run(positions);
  if (options_.swept) {
    CpuSearch near(info_, threads_);
    const auto list = [&](const Scene& grown) {
      near.upload(grown);
      return near.list_pairs(grown.positions, near_options(options_));
    };
    const std::vector<vec4> velocities = path_velocities(state, saved, motion_, params_, list);
    found_ = search_swept(input, velocities, list(spheres_around_paths(positions, velocities, params_.motion)));
  } else if (options_.method == Method::sequential) {
    found_ = search_sequential(input);
  } else if (options_.method == Method::collide_group) {
    found_ = search_groups(input);
  } else if (options_.method == Method::collide_grid) {
    found_ = search_cells(input);
  } else {
    found_ = search_parallel(input);
  }
}

const std::vector<Pair>& CpuSearch::list_pairs(const std::vector<vec4>& positions, CollideOptions options) {
  options.want_pairs = true;
  n_ = positions.size();  // with images of a periodic box they are now more, now fewer
  params_.n = uint(n_);
  prepare(options, positions);
  run(positions);
  return pairs();
}

const PairsFound& CpuSearch::found() const {
  if (!found_) throw BackendError("cpu: no collision step to report since the last move; call collide first");
  return *found_;
}

std::vector<uint> CpuSearch::counts() const {
  const PairsFound& last = found();
  const bool of_near_pairs = options_.swept || periodic_axes(params_.contact) != 0;
  return options_.method == Method::collide_grid && !of_near_pairs ? grid_.counts(threads_) : last.counts;
}

const std::vector<Pair>& CpuSearch::pairs() const {
  const std::vector<Pair>& list = found().list;
  if (!options_.want_pairs) throw BackendError("cpu: no pair list was requested; set want_pairs");
  return list;
}

Params CpuSearch::light_cells() const {
  Params params = params_;
  params.grid = grid_params(plans_.light);
  return params;
}

}  // namespace spherepair
