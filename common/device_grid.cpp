// SPDX-License-Identifier: MIT
// The collision step of DeviceBackend through the grid: spheres into cell order, then half neighbourhoods.
#include <fmt/format.h>

#include <algorithm>

#include "device_backend.h"

namespace spherepair {
namespace {

constexpr uint64_t most_spheres = SCAN_PARTIAL - 1;
constexpr uint64_t cells_per_tile = uint64_t(SCAN_BLOCK) * SCAN_VECTORS * 4;
constexpr uint64_t collide_groups = 4096;

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

// Parameters of the cells that the options ask for, and room for them.
void DeviceBackend::plan_cells() {
  const GridPlan& plan = plans_.plan(options_.grid.cells);
  set_grid(params_, plan);
  params_.scan_tiles = uint(ceil_div(uint64_t(plan.slots) + 1, cells_per_tile));
  if (planned_ == plan.cells) return;
  if (n_ > most_spheres) {
    throw BackendError(fmt::format("{}: {} spheres, but the grid takes {} at most; use collide_triangle", info().name,
                                   n_, most_spheres));
  }
  make_buffer(SLOT_CELL, params_.scan_tiles * cells_per_tile * sizeof(uint));
  make_buffer(SLOT_SCAN, (params_.scan_tiles + 1) * sizeof(uint));
  planned_ = plan.cells;
  cells_built_ = false;
  cell_order_.reset();
}

void DeviceBackend::make_sort_buffers() {
  make_buffer(SLOT_RANK, n_ * sizeof(uint));
  make_buffer(SLOT_SORTED, n_ * sizeof(vec4));
  make_buffer(SLOT_ID, n_ * sizeof(uint));
  make_buffer(SLOT_SORTED_COUNT, n_ * sizeof(uint));
}

void DeviceBackend::launch_bounds() {
  const uint64_t threads = std::max<uint64_t>(n_ + 1, SUMMARY_SLOTS * SUMMARY_WORDS);
  launch({Kernel::grid_bounds, SERVICE_BLOCK, {}, folded(ceil_div(threads, SERVICE_BLOCK * SPHERES_PER_SORTER))},
         params_);
}

// Asked once after spheres have moved; only then does the host wait for the device.
bool DeviceBackend::stands_in_cell_order() {
  if (!options_.grid.keep_order) return false;
  if (!cell_order_) {
    uint disorder = 0;
    write(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    launch_bounds();
    read(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    cell_order_ = disorder == 0;
  }
  return *cell_order_;
}

void DeviceBackend::sort_into_cells() {
  make_sort_buffers();
  const auto sorters = folded(ceil_div(n_, SERVICE_BLOCK * SPHERES_PER_SORTER));
  const uint64_t clearers = std::max<uint64_t>(params_.cell_slots / 4 + 1, SUMMARY_SLOTS * SUMMARY_WORDS);
  launch({Kernel::grid_clear, SERVICE_BLOCK, {}, folded(ceil_div(clearers, SERVICE_BLOCK))}, params_);
  launch({Kernel::grid_count, SERVICE_BLOCK, {}, sorters}, params_);
  launch({Kernel::grid_scan, SCAN_BLOCK, {}, folded(params_.scan_tiles)}, params_);
  launch({Kernel::grid_scatter, SERVICE_BLOCK, {}, sorters}, params_);
}

// Cells of the spheres as they stand, and the results of the last step cleared.
void DeviceBackend::build_cells() {
  const bool built = cells_built_ && options_.grid.keep_cells;
  if (!built) sorted_ = !stands_in_cell_order();
  params_.in_cells = sorted_;
  if (!built && sorted_) return sort_into_cells();
  if (!built) return launch_bounds();
  if (!cleared_ || sorted_) launch_clear(sorted_);
}

void DeviceBackend::launch_grid() {
  plan_cells();
  build_cells();
  cells_built_ = true;
  params_.tally_later = true;
  tallied_ = false;
  const bool hashed = params_.hash_mask != 0;
  const uint groups = uint(std::min(ceil_div(n_, options_.block), collide_groups));
  const Kernel kernel = hashed ? Kernel::collide_hashed : Kernel::collide_grid;
  launch({kernel, options_.block, variant_, {groups, 1, 1}, sorted_}, params_);
}

}  // namespace spherepair
