// SPDX-License-Identifier: MIT
#include "common/simulation/search/sphere_sort.h"

#include <algorithm>

#include "common/plan/grid_plan.h"

namespace spherepair {
namespace {

static_assert(SCAN_TILE == SCAN_BLOCK * SCAN_VECTORS * 4);
// Minimum of grid_sort's groups on a GPU, if there are as many cells: with fewer, most of the GPU idles. In software
// every group costs time, so the automatic choice has no minimum there. It sorts fewer than
// buckets_pay_from_in_software spheres by counting.
constexpr uint least_buckets = 64;
constexpr uint64_t buckets_pay_from_in_software = 16384;  // spheres

}  // namespace

SphereSort::SphereSort(DeviceContext& context, const CollideOptions& options, bool index_in_w)
    : context_(context),
      options_(options),
      index_in_w_(index_in_w),
      slots_(context.params.grid.cell_slots),
      cells_{.dense = context.params.grid.hash_mask == 0} {}

void SphereSort::launch(Kernel kernel, uint block, uint64_t groups) {
  context_.launch({.kernel = kernel, .block = block, .variant = cells_, .groups = folded(groups)});
}

void SphereSort::scan(uint table) {
  for (const Kernel kernel : {Kernel::grid_sums, Kernel::grid_scan})
    context_.launch(
        {kernel, SCAN_BLOCK, {}, folded(context_.params.sort.scan_tiles), Order::scene, Order::cells, table});
}

// Clears the table or the buckets, and the totals.
void SphereSort::clear(uint64_t bucket_words) {
  const uint64_t table_words = bucket_words ? 0 : slots_ + 2;
  if (options_.api.library_clear.value_or(false)) {
    context_.buffers.clear(bucket_words ? SLOT_BUCKET : SLOT_CELL, (bucket_words + table_words) * sizeof(uint));
    return context_.buffers.clear(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  }
  const uint64_t threads = std::max({table_words / 4 + 2, bucket_words, uint64_t(SUMMARY_SLOTS * SUMMARY_WORDS)});
  launch(Kernel::grid_clear, SERVICE_BLOCK, ceil_div(threads, SERVICE_BLOCK));
}

// Sorts by a histogram of the cells, its prefix sums and a scatter: least work, most launches.
void SphereSort::by_counting() {
  SortParams& sort = context_.params.sort;
  const uint64_t groups = ceil_div(context_.n, SERVICE_BLOCK * SPHERES_PER_SORTER);
  sort.scan_tiles = uint(ceil_div(uint64_t(slots_) + 2, SCAN_TILE));
  context_.buffers.resize(SLOT_SCAN, (sort.scan_tiles + 1) * sizeof(uint));
  clear(0);
  launch(Kernel::grid_count, SERVICE_BLOCK, groups);
  scan(SLOT_CELL);
  launch(Kernel::grid_scatter, SERVICE_BLOCK, groups);
}

void SphereSort::split(uint shift, uint parent_shift, uint first_bucket, Order from, Order to) {
  SortParams& sort = context_.params.sort;
  const auto tiles = folded(ceil_div(context_.n, SPLIT_TILE));
  sort.bucket_shift = shift;
  sort.parent_shift = parent_shift;
  sort.first_bucket = first_bucket;
  sort.buckets = (slots_ >> shift) + 1;
  sort.index_given = from != Order::scene;
  context_.launch(
      {.kernel = Kernel::split_count, .block = SPLIT_BLOCK, .variant = cells_, .groups = tiles, .order = from});
  if (first_bucket == 0) {  // there are at most BUCKETS_AT_MOST buckets
    context_.launch({Kernel::split_scan, BUCKETS_AT_MOST, {}, {1, 1, 1}});
  } else {
    scan(SLOT_BUCKET);
  }
  context_.launch({.kernel = Kernel::grid_split,
                   .block = SPLIT_BLOCK,
                   .variant = cells_,
                   .groups = tiles,
                   .order = from,
                   .target = to});
}

// Splits each tile of spheres by itself; grid_sort then collects from all tiles. One group must tell all buckets apart.
void SphereSort::split_tiles(uint shift, uint buckets) {
  const uint64_t tiles = ceil_div(context_.n, SPLIT_TILE);
  context_.params.sort.bucket_shift = shift;
  context_.params.sort.buckets = buckets;
  context_.buffers.resize(SLOT_BUCKET, ceil_div(context_.room, SPLIT_TILE) * BUCKETS_AT_MOST * sizeof(uint));
  context_.launch({Kernel::split_tiles, SPLIT_BLOCK, cells_, folded(tiles), Order::scene, Order::buckets});
}

void SphereSort::split_twice(uint shift, uint buckets, uint parent_shift) {
  SortParams& sort = context_.params.sort;
  sort.scan_tiles = uint(ceil_div(buckets, SCAN_TILE));
  sort.bucket_words = (sort.scan_tiles + 1) * SCAN_TILE;
  sort.buckets = buckets;
  context_.buffers.resize(SLOT_BUCKET, sort.bucket_words * sizeof(uint));
  context_.buffers.resize(SLOT_SCAN, (sort.scan_tiles + 1) * sizeof(uint));
  clear(sort.bucket_words);
  split(parent_shift, ONE_PARENT, 0, Order::scene, Order::cells);
  split(shift, parent_shift, SCAN_TILE, Order::cells, Order::buckets);
}

// Splits the spheres into ranges of cells, in two passes if there are many ranges, until each fits into a group's
// shared memory. Writes are then contiguous.
void SphereSort::by_buckets() {
  const bool few = context_.software() && options_.grid.sort == Sort::automatic;
  const auto [shift, buckets, parent_shift] = plan_buckets(context_.n, slots_, few ? 1 : least_buckets);
  const bool tiles = parent_shift == ONE_PARENT;
  context_.buffers.resize(SLOT_SPLIT, context_.room * sizeof(vec4));
  if (!index_in_w_) context_.buffers.resize(SLOT_SPLIT_ID, context_.room * sizeof(uint));
  tiles ? split_tiles(shift, buckets) : split_twice(shift, buckets, parent_shift);
  Launch launching{Kernel::grid_sort, SORT_BLOCK, cells_, folded(buckets), Order::buckets};
  launching.variant.from_tiles = tiles;
  context_.launch(launching);
}

void SphereSort::by_library() {
  context_.buffers.clear(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  context_.device.library()->sort_spheres(context_.params, context_.buffers.handles());
}

void SphereSort::run() {
  const Sort wanted = options_.grid.sort;
  context_.params.sort = {};
  context_.params.sort.index_in_w = index_in_w_;
  context_.buffers.resize(SLOT_SORTED, context_.room * sizeof(vec4));
  if (!index_in_w_ || wanted == Sort::radix) context_.buffers.resize(SLOT_ID, context_.room * sizeof(uint));
  context_.buffers.resize(SLOT_SORTED_COUNT, context_.room * sizeof(uint));
  if (wanted == Sort::radix) return by_library();
  const bool pays = !context_.software() || context_.n >= buckets_pay_from_in_software;
  const bool buckets = wanted == Sort::automatic ? pays : wanted == Sort::buckets;
  buckets ? by_buckets() : by_counting();
}

}  // namespace spherepair
