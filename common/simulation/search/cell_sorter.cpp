// SPDX-License-Identifier: MIT
#include "common/simulation/search/cell_sorter.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/simulation/search/sphere_sort.h"

namespace spherepair {
namespace {

constexpr uint64_t most_spheres = (1u << 30) - 1;
constexpr uint64_t least_moves_to_wait = 32, most_moves_to_wait = 64;

}  // namespace

void CellSorter::upload(const Scene& scene) {
  plans_ = plan_grids(scene.positions);
  watch_ = PlanWatch(scene, plans_);
  planned_.reset();
  cell_order_.reset();
  moves_to_wait_ = 0;
  looked_at_ = watched_ = context_.moves;
  built_of_.reset();
  order_ = Order::scene;
}

uint CellSorter::indices(Order order) const {
  return order != Order::cells ? 0 : index_in_w_ ? INDEX_IN_W : INDEX_IN_ID;
}

std::vector<uint> CellSorter::sphere_indices() {
  if (!index_in_w_) return context_.buffers.read<uint>(SLOT_ID, context_.n);
  std::vector<uint> indices(context_.n);
  const std::vector<vec4> sorted = context_.buffers.read<vec4>(SLOT_SORTED, context_.n);
  for (uint64_t k = 0; k < context_.n; ++k) indices[k] = float_bits(sorted[k].w);
  return indices;
}

// Reads the positions of 2^16 spheres from all over the scene, or of all if there are no more.
std::vector<vec4> CellSorter::sample_positions() {
  constexpr uint64_t size = 1 << 16;
  if (context_.n <= size) return context_.buffers.read<vec4>(SLOT_POSITION, context_.n);
  context_.buffers.grow(SLOT_SPLIT, size * sizeof(vec4));
  context_.launch({Kernel::sample, SERVICE_BLOCK, {}, folded(size / SERVICE_BLOCK), Order::scene, Order::buckets});
  return context_.buffers.read<vec4>(SLOT_SPLIT, size);
}

bool CellSorter::replan_if_needed() {
  for (; watched_ != context_.moves; ++watched_) watch_.moved();
  if (!watch_.needed()) return false;
  const std::vector<vec4> sample = sample_positions();
  if (!watch_.worthwhile(sample, plans_) || !watch_.replan(sample, context_.n, plans_)) return false;
  ++context_.work().plans;
  planned_.reset();
  return true;
}

// Sets the parameters of the cells and makes room for the table.
void CellSorter::plan_cells(const GridPlan& plan) {
  const bool leveled = plan.cells == Cells::dense && plan.top_level != 0;
  if (planned_ == plan.cells && leveled_ == leveled) return;
  planned_.reset();  // stays empty if there is no room
  built_of_.reset();
  cell_order_.reset();
  context_.params.grid = grid_params(plan);
  if (context_.n > most_spheres) {
    throw BackendError(fmt::format("{}: {} spheres, but the grid takes {} at most; use collide_triangle",
                                   context_.name(), context_.n, most_spheres));
  }
  context_.buffers.grow(SLOT_CELL, ceil_div(uint64_t(plan.slots) + 2, SCAN_TILE) * SCAN_TILE * sizeof(uint));
  context_.buffers.resize(SLOT_SCAN, sizeof(uint));
  planned_ = plan.cells;
  leveled_ = leveled;
}

void CellSorter::launch_bounds() {
  const uint64_t threads = std::max<uint64_t>(context_.n + 1, SUMMARY_SLOTS * SUMMARY_WORDS);
  const Variant variant{.dense = context_.params.grid.hash_mask == 0};
  context_.launch({Kernel::grid_bounds, context_.device.capabilities().bounds_block, variant,
                   folded(ceil_div(threads, BOUNDS_TILE))});
}

// Whether the spheres are in cell order already. The host waits for this answer, so it asks once after spheres have
// moved, and ever more rarely while the answer is no.
bool CellSorter::stands_in_cell_order(const GridOptions& options) {
  if (!options.keep_order) return false;
  const uint64_t moves = context_.moves - looked_at_;
  if (moves != 0) cell_order_.reset();
  if (!cell_order_ && moves < moves_to_wait_) return false;
  if (!cell_order_) {
    uint disorder = 0;
    context_.buffers.write(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    launch_bounds();
    context_.buffers.read(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    cell_order_ = disorder == 0;
    moves_to_wait_ = *cell_order_ ? 0 : std::clamp(2 * moves_to_wait_, least_moves_to_wait, most_moves_to_wait);
    looked_at_ = context_.moves;
  }
  return *cell_order_;
}

void CellSorter::build(const CollideOptions& options, bool equal_radii, bool results_clear) {
  plan_cells(plans_.plan(options.grid.cells));
  const bool same_indices = order_ == Order::scene || index_in_w_ == equal_radii;
  const bool kept = built() && options.grid.keep_cells && same_indices;
  if (!kept) {
    built_of_.reset();  // stays empty if the sort fails
    order_ = stands_in_cell_order(options.grid) ? Order::scene : Order::cells;
    if (order_ == Order::cells) index_in_w_ = equal_radii;
  }
  const bool sorted = order_ == Order::cells;
  WorkCounts& work = context_.work();
  ++(kept ? work.cells_kept : sorted ? work.sorts : work.orders_kept);
  if (kept) {
    if (!results_clear || sorted) clear_results(context_, order_);
  } else if (sorted) {
    SphereSort(context_, options, index_in_w_).run();
  } else {
    launch_bounds();
  }
  built_of_ = context_.moves;
}

void CellSorter::build_for_light() {
  plan_cells(plans_.light);
  built_of_.reset();  // stays empty if the sort fails
  order_ = Order::cells;
  index_in_w_ = context_.equal_radii;
  ++context_.work().sorts;
  SphereSort(context_, {}, index_in_w_).run();
  built_of_ = context_.moves;
}

}  // namespace spherepair
