// SPDX-License-Identifier: MIT
// The collision step of DeviceBackend through the grid: spheres into cell order, then half neighbourhoods.
#include <fmt/format.h>

#include <algorithm>

#include "common/device/device_backend.h"

namespace spherepair {
namespace {

constexpr uint64_t most_spheres = (1u << 30) - 1;
static_assert(SCAN_TILE == SCAN_BLOCK * SCAN_VECTORS * 4);
// Fewer are in the caches together, so that a group of the search may take some here, some there; of more it takes so
// few chunks in a row that neighbours are at work.
constexpr uint64_t spheres_near = 4'000'000;
constexpr uint64_t most_groups = 4096;  // of few spheres: a large device has some left when others are done
constexpr uint threads_per_chunk = 32;  // of a group, which takes that many chunks in a row of many spheres
constexpr uint64_t least_moves_to_wait = 32, most_moves_to_wait = 64;
// Groups of the sort, if there are cells for so many: with fewer, most of a device waits for them. In software each
// group costs its threads, so that, unless buckets are asked for, they are few, and few spheres are sorted by counting.
constexpr uint least_buckets = 64;
constexpr uint64_t buckets_pay_from_in_software = 16384;  // spheres

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

// Parameters of the cells that the options ask for, and room for them.
void DeviceBackend::plan_cells() {
  const GridPlan& plan = plans_.plan(options_.grid.cells);
  set_grid(params_, plan, options_.grid.prune_cells);
  if (planned_ == plan.cells) return;
  if (n_ > most_spheres) {
    throw BackendError(fmt::format("{}: {} spheres, but the grid takes {} at most; use collide_triangle", info().name,
                                   n_, most_spheres));
  }
  make_buffer(SLOT_CELL, ceil_div(uint64_t(plan.slots) + 2, SCAN_TILE) * SCAN_TILE * sizeof(uint));
  make_buffer(SLOT_SCAN, sizeof(uint));
  planned_ = plan.cells;
  cells_built_ = false;
  cell_order_.reset();
}

void DeviceBackend::launch_bounds() {
  const uint64_t threads = std::max<uint64_t>(n_ + 1, SUMMARY_SLOTS * SUMMARY_WORDS);
  launch({Kernel::grid_bounds, bounds_block(), sorter(Kernel::grid_bounds), folded(ceil_div(threads, BOUNDS_TILE))},
         params_);
}

// Read once after spheres have moved, and more and more rarely while the answer is no, since the host then
// waits for the device.
bool DeviceBackend::stands_in_cell_order() {
  if (!options_.grid.keep_order) return false;
  if (!cell_order_ && moves_waited_ < moves_to_wait_) return false;
  if (!cell_order_) {
    uint disorder = 0;
    write(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    launch_bounds();
    read(SLOT_SCAN, &disorder, 0, sizeof(disorder));
    cell_order_ = disorder == 0;
    moves_to_wait_ = *cell_order_ ? 0 : std::clamp(2 * moves_to_wait_, least_moves_to_wait, most_moves_to_wait);
    moves_waited_ = 0;
  }
  return *cell_order_;
}

// Those of buckets read spheres through textures, but for split_tiles, which is faster without.
Variant DeviceBackend::sorter(Kernel kernel) const {
  const bool texture = kernel == Kernel::split_count || kernel == Kernel::grid_split || kernel == Kernel::grid_sort;
  return {.texture_table = texture && takes_texture(kernel, options_.api), .dense = params_.hash_mask == 0};
}

void DeviceBackend::launch_sorter(Kernel kernel, uint block, uint64_t groups) {
  launch({kernel, block, sorter(kernel), folded(groups)}, params_);
}

void DeviceBackend::launch_scan(uint table) {
  for (const Kernel kernel : {Kernel::grid_sums, Kernel::grid_scan})
    launch({kernel, SCAN_BLOCK, {}, folded(params_.scan_tiles), Order::scene, Order::cells, table}, params_);
}

// The table or the buckets, and the totals, for a new sort.
void DeviceBackend::clear_for_sort(uint64_t bucket_words) {
  const uint64_t table_words = bucket_words ? 0 : params_.cell_slots + 2;
  if (options_.api.library_clear.value_or(false)) {
    clear_buffer(bucket_words ? SLOT_BUCKET : SLOT_CELL, (bucket_words + table_words) * sizeof(uint));
    return clear_buffer(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  }
  const uint64_t clearers = std::max({table_words / 4 + 2, bucket_words, uint64_t(SUMMARY_SLOTS * SUMMARY_WORDS)});
  launch_sorter(Kernel::grid_clear, SERVICE_BLOCK, ceil_div(clearers, SERVICE_BLOCK));
}

// By counting: a histogram of the cells, its sums, a scatter. The least work, in the most launches.
void DeviceBackend::sort_by_counting() {
  const uint64_t sorters = ceil_div(n_, SERVICE_BLOCK * SPHERES_PER_SORTER);
  params_.buckets = params_.bucket_words = params_.first_bucket = 0;
  params_.scan_tiles = uint(ceil_div(uint64_t(params_.cell_slots) + 2, SCAN_TILE));
  make_buffer(SLOT_SCAN, (params_.scan_tiles + 1) * sizeof(uint));
  clear_for_sort(0);
  launch_sorter(Kernel::grid_count, SERVICE_BLOCK, sorters);
  options_.grid.scan == Scan::library ? library_scan() : launch_scan(SLOT_CELL);
  launch_sorter(Kernel::grid_scatter, SERVICE_BLOCK, sorters);
}

void DeviceBackend::split(uint shift, uint parent_shift, uint first_bucket, Order from, Order to) {
  const auto tiles = folded(ceil_div(n_, SPLIT_TILE));
  params_.bucket_shift = shift;
  params_.parent_shift = parent_shift;
  params_.first_bucket = first_bucket;
  params_.buckets = (params_.cell_slots >> shift) + 1;
  if (from != Order::scene) params_.indices |= INDEX_GIVEN;
  launch({Kernel::split_count, SPLIT_BLOCK, sorter(Kernel::split_count), tiles, from}, params_);
  if (first_bucket == 0) {  // at most BUCKETS_AT_MOST
    launch({Kernel::split_scan, BUCKETS_AT_MOST, {}, {1, 1, 1}}, params_);
  } else {
    launch_scan(SLOT_BUCKET);
  }
  launch({Kernel::grid_split, SPLIT_BLOCK, sorter(Kernel::grid_split), tiles, from, to}, params_);
}

// Where one group tells all buckets apart: each tile of spheres by itself, from all of which the sort collects.
void DeviceBackend::split_tiles(uint shift, uint buckets) {
  const uint64_t tiles = ceil_div(n_, SPLIT_TILE);
  params_.bucket_shift = shift;
  params_.buckets = buckets;
  make_buffer(SLOT_BUCKET, tiles * BUCKETS_AT_MOST * sizeof(uint));
  const Variant variant = sorter(Kernel::split_tiles);
  Launch launching{Kernel::split_tiles, SPLIT_BLOCK, variant, folded(tiles), Order::scene, Order::buckets};
  launching.overlaps_previous = overlaps_search();
  launch(launching, params_);
}

void DeviceBackend::split_twice(uint shift, uint buckets, uint parent_shift) {
  params_.scan_tiles = uint(ceil_div(buckets, SCAN_TILE));
  params_.bucket_words = (params_.scan_tiles + 1) * SCAN_TILE;
  params_.buckets = buckets;
  make_buffer(SLOT_BUCKET, params_.bucket_words * sizeof(uint));
  make_buffer(SLOT_SCAN, (params_.scan_tiles + 1) * sizeof(uint));
  clear_for_sort(params_.bucket_words);
  split(parent_shift, ONE_PARENT, 0, Order::scene, Order::cells);
  split(shift, parent_shift, SCAN_TILE, Order::cells, Order::buckets);
}

// By buckets: split into ranges of cells, in two steps when they are many, until each fits a group's shared memory;
// what is written then lies side by side.
void DeviceBackend::sort_by_buckets() {
  const bool few = info().software && options_.grid.sort == Sort::automatic;
  const auto [shift, buckets, parent_shift] = plan_buckets(n_, params_.cell_slots, few ? 1 : least_buckets);
  const bool tiles = parent_shift == ONE_PARENT;
  make_buffer(SLOT_SPLIT, n_ * sizeof(vec4));
  if (!variant_.equal_radii) make_buffer(SLOT_SPLIT_ID, n_ * sizeof(uint));
  tiles ? split_tiles(shift, buckets) : split_twice(shift, buckets, parent_shift);
  Variant variant = sorter(Kernel::grid_sort);
  variant.from_tiles = tiles;
  launch({Kernel::grid_sort, SORT_BLOCK, variant, folded(buckets), Order::buckets}, params_);
}

void DeviceBackend::sort_by_library() {
  clear_buffer(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  library_sort();
}

void DeviceBackend::sort_into_cells() {
  params_.indices = index_in_w_ ? INDEX_IN_W : 0;
  make_buffer(SLOT_SORTED, n_ * sizeof(vec4));
  if (!index_in_w_ || options_.grid.sort == Sort::radix) make_buffer(SLOT_ID, n_ * sizeof(uint));
  make_buffer(SLOT_SORTED_COUNT, n_ * sizeof(uint));
  if (options_.grid.sort == Sort::radix) return sort_by_library();
  const bool pays = options_.grid.scan == Scan::own && (!info().software || n_ >= buckets_pay_from_in_software);
  const bool buckets = options_.grid.sort == Sort::automatic ? pays : options_.grid.sort == Sort::buckets;
  buckets ? sort_by_buckets() : sort_by_counting();
}

// Cells of the spheres as they stand, and the results of the last step cleared.
void DeviceBackend::build_cells() {
  const bool named = order_ == Order::scene || index_in_w_ == variant_.equal_radii;
  const bool built = cells_built_ && options_.grid.keep_cells && named;
  if (!built) order_ = stands_in_cell_order() ? Order::scene : Order::cells;
  const bool sorted = order_ == Order::cells;
  if (!built) cells_built_ = false;  // until they are, should that fail
  if (!built && sorted) index_in_w_ = variant_.equal_radii;
  params_.in_cells = indices_of(order_);
  ++(built ? work_.cells_kept : sorted ? work_.sorts : work_.orders_kept);
  if (!built && sorted) return sort_into_cells();
  if (!built) return launch_bounds();
  if (!cleared_ || sorted) launch_clear(order_);
}

void DeviceBackend::launch_grid() {
  plan_cells();
  // Before the first launch: parameters that change within a step are sent again.
  params_.columns_per_group = options_.block * (n_ < spheres_near ? 1 : options_.block / threads_per_chunk);
  params_.totals_later = !options_.want_totals && !options_.want_pairs;
  build_cells();
  cells_built_ = true;
  const bool hashed = params_.hash_mask != 0;
  Variant variant = variant_;
  const Kernel kernel = hashed ? Kernel::collide_hashed : Kernel::collide_grid;
  variant.texture_table = !hashed && takes_texture(kernel, options_.api);
  const uint64_t stretches = ceil_div(n_, params_.columns_per_group);
  const uint64_t groups = n_ < spheres_near ? std::min(stretches, most_groups) : stretches;
  launch({kernel, options_.block, variant, folded(groups), order_}, params_);
}

}  // namespace spherepair
