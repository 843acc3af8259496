// SPDX-License-Identifier: MIT
#include "common/simulation/search/pair_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/backend/checks.h"
#include "common/backend/method_choice.h"
#include "common/simulation/search/all_pairs.h"

namespace spherepair {
namespace {

constexpr uint resolve_groups = 64;
// Below this many spheres all of them fit into the caches, so groups of collide_grid stride through them. Above it each
// group takes so few consecutive chunks that neighbouring groups work on neighbouring cells.
constexpr uint64_t cached_spheres = 4'000'000;
constexpr uint64_t most_groups = 4096;  // for few spheres or for pairs: balances the load on a large device
constexpr uint threads_per_chunk = 32;  // for many spheres a group takes one chunk per so many threads, in a row

}  // namespace

void PairSearch::upload(const Scene& scene) {
  const uint64_t n = scene.size();
  make_room();
  context_.buffers.resize(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  context_.buffers.resize(SLOT_DEFERRED, std::max<uint64_t>(n, 4096) * sizeof(uvec2));
  context_.buffers.resize(SLOT_PAIR, std::max<uint64_t>(n, 4096) * sizeof(uvec2));
  constants_ = {search_params(scene, false), search_params(scene, true)};
  order_ = Order::scene;
  results_ = Results::none;
  results_clear_ = counts_sorted_ = false;
  resolved_in_step_.clear();
}

void PairSearch::make_room() {
  context_.buffers.resize(SLOT_COUNT, context_.room * sizeof(uint));
  forget();
}

void PairSearch::forget() {
  results_clear_ = false;
  results_ = Results::none;
}

MethodChoice PairSearch::choice(const CollideOptions& options) const {
  return explain_choice(context_.device.info(), context_.n, sorter_.plans(), options);
}

void PairSearch::choose(const CollideOptions& options) {
  const BackendInfo& info = context_.device.info();
  options_ = options;
  options_.method = chosen_method(info, context_.n, sorter_.plans(), options);
  const bool may_use_grid = options.method == Method::collide_grid ||
                            (options.method == Method::automatic && double(context_.n) >= crossover_of(info).grid_from);
  if (options.grid.replan && may_use_grid && sorter_.replan_if_needed())
    options_.method = chosen_method(info, context_.n, sorter_.plans(), options);
  options_.block = chosen_block(info, context_.n, options_.method, options);
}

void PairSearch::require_options(const CollideOptions& options) const {
  const bool small = options.method == Method::collide_tiled && std::ranges::count(small_block_sizes(), options.block);
  if (!small && std::ranges::count(block_sizes(), options.block) == 0)
    throw std::invalid_argument(
        fmt::format("group size {} is not one of {}", options.block, fmt::join(block_sizes(), ", ")));
  check_collide(options);
  context_.device.check(options);
  refuse_tensor(context_.name(), options, context_.device.capabilities().tensor_groups != 0);
}

void PairSearch::enqueue(const CollideOptions& options, bool in_step) {
  require_options(options);
  choose(options);
  launch(in_step);
}

// Sets the scene's constants and the options.
void PairSearch::set_params() {
  SearchParams& params = context_.params.search;
  params = constants_[options_.exact];
  if (!options_.filter) leave_all_undecided(params);
  params.columns_per_group = options_.columns ? options_.columns : default_columns(context_.n, context_.software());
  params.pair_capacity = options_.want_pairs ? uint(context_.buffers.bytes(SLOT_PAIR) / sizeof(uvec2)) : 0;
  params.near_pairs = context_.near_pairs;
  params.deferred_capacity = uint(context_.buffers.bytes(SLOT_DEFERRED) / sizeof(uvec2));
}

// Prepares any search: parameters, the variant and counts of its work.
void PairSearch::prepare_launch() {
  ++context_.version;
  context_.params.first_group = 0;
  set_params();
  variant_.equal_radii = context_.equal_radii && !options_.load_radii;
  variant_.listed = options_.want_pairs;
  variant_.indices = 0;
  WorkCounts& work = context_.work();
  ++work.steps;
  work.without_radii += variant_.equal_radii;
  work.lists += variant_.listed;
  results_ = Results::none;  // until all is launched
}

// Launches steps as one persistent kernel. It clears counts before every search, and leaves undecided pairs undecided.
void PairSearch::enqueue_steps(uint steps) {
  options_ = {.method = Method::collide_triangle};
  prepare_launch();
  context_.work().steps += steps - 1;
  search_decides_ = results_clear_ = counts_sorted_ = false;
  sorter_.forget_order();
  order_ = Order::scene;
  const uint64_t parts =
      ceil_div(context_.n, SERVICE_BLOCK) * ceil_div(context_.n, context_.params.search.columns_per_group);
  const uint64_t at_once = context_.device.capabilities().persistent_groups;
  const uint groups = uint(std::clamp<uint64_t>(parts, 1, at_once));
  context_.launch({.kernel = Kernel::persistent_steps,
                   .block = SERVICE_BLOCK,
                   .variant = variant_,
                   .groups = {groups, 1, 1},
                   .steps = steps});
  resolved_ = false;
  if (resolved_in_step_.contains(kind())) resolve_undecided();
  launched();
}

void PairSearch::launch(bool in_step) {
  prepare_launch();
  const bool grid = options_.method == Method::collide_grid && context_.n >= 2 && !of_near_pairs();
  search_decides_ = grid && sorter_.plans().plan(options_.grid.cells).cells == Cells::dense;
  resolved_ = true;
  if (!grid) sorter_.forget_order();
  if (!in_step) context_.device.begin_step(options_.api);
  const bool clear = std::exchange(results_clear_, false);
  if (!grid && !clear) clear_results(context_, Order::scene);
  if (of_near_pairs()) {
    launch_near();
  } else if (context_.n >= 2) {
    grid ? launch_grid(clear) : launch_all_pairs(context_, options_, variant_);
    resolved_ = !options_.exact;
  }
  order_ = sorter_.order();
  counts_sorted_ = order_ == Order::cells;
  if (resolved_in_step_.contains(kind())) resolve_undecided();
  context_.device.end_step();
  launched();
}

void PairSearch::launch_grid(bool results_clear) {
  Params& params = context_.params;
  const bool few = context_.n < cached_spheres;
  // Set before the first launch, since parameters that change within a step are sent again.
  params.search.chunk = options_.block * (few ? 1 : options_.block / threads_per_chunk);
  sorter_.build(options_, variant_.equal_radii, results_clear);
  variant_.indices = sorter_.indices(sorter_.order());
  Launch launching{params.grid.hash_mask != 0 ? Kernel::collide_hashed : Kernel::collide_grid, options_.block,
                   variant_};
  if (launching.kernel == Kernel::collide_grid) {
    launching.texels = uint64_t(params.grid.cell_slots) + 2;
    launching.variant.texture_table =
        context_.device.reads_texture(launching.kernel, params, launching.texels, options_.api.texture_table);
  }
  const uint64_t chunks = ceil_div(context_.n, params.search.chunk);
  launching.groups = folded(few ? std::min(chunks, most_groups) : chunks);
  launching.order = sorter_.order();
  context_.launch(launching);
}

// Decides the near pairs, one thread each.
void PairSearch::launch_near() {
  const uint64_t groups = std::clamp<uint64_t>(ceil_div(context_.near_pairs, SERVICE_BLOCK), 1, most_groups);
  const Kernel kernel = options_.swept ? Kernel::collide_swept : Kernel::collide_images;
  context_.launch({kernel, SERVICE_BLOCK, {.listed = variant_.listed}, folded(groups)});
}

// Decides the deferred pairs. There hardly ever are any, so a complete search launches this only if a pair is left.
// Then it is part of every step of that kind of search, until a complete search leaves none.
void PairSearch::resolve_undecided() {
  if (resolved_) return;
  context_.launch({Kernel::resolve_undecided, SERVICE_BLOCK, variant_, {resolve_groups, 1, 1}, order_});
  resolved_ = true;
}

void PairSearch::prepare_counts(bool sorted) {
  if (results() == Results::none) {
    if (!results_clear_) clear_results(context_, Order::scene);
    results_clear_ = true;
    return;
  }
  resolve_undecided();
  if (!counts_sorted_ || sorted) return;
  context_.launch({Kernel::draw_unsort_counts,
                   SERVICE_BLOCK,
                   {.indices = sorter_.indices(Order::cells)},
                   folded(ceil_div(context_.n, SERVICE_BLOCK))});
  counts_sorted_ = false;
}

}  // namespace spherepair
