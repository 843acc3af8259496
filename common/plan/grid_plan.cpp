// SPDX-License-Identifier: MIT
#include "common/plan/grid_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "common/plan/dense_plan.h"
#include "common/shared/cell.h"
#include "common/shared/view.h"

namespace spherepair {
namespace {

constexpr uint64_t sample_size = 1 << 16;
constexpr uint64_t spheres_per_bucket =
    SORT_EACH * SORT_BLOCK * 5 / 6;  // upper limit of the mean: few buckets then exceed a group's threads
static_assert(SORT_EACH * SORT_BLOCK <= CELLS_PER_BUCKET);
constexpr float many_octaves = 4;  // ratio of the largest to the smallest radius from which on levels pay

// Returns the median coordinate of a sample. As the plan's origin it puts the finest float32 numbers where most spheres
// are, whatever the outliers.
float middle_of(const std::vector<vec4>& spheres, float vec4::*axis) {
  const uint64_t m = std::min<uint64_t>(spheres.size(), 1023);
  std::vector<float> sample(m);
  for (uint64_t k = 0; k < m; ++k) sample[k] = spheres[k * spheres.size() / m].*axis;
  std::erase_if(sample, [](float x) { return !std::isfinite(x); });
  const auto middle = sample.begin() + ptrdiff_t(sample.size() / 2);
  std::ranges::nth_element(sample, middle);
  return sample.empty() ? 0 : *middle;
}

void set_middle(GridPlan& plan, const std::vector<vec4>& spheres) {
  plan.origin[0] = middle_of(spheres, &vec4::x);
  plan.origin[1] = middle_of(spheres, &vec4::y);
  plan.origin[2] = middle_of(spheres, &vec4::z);
}

GridPlan hashed_plan(const std::vector<vec4>& spheres, const Extent& extent) {
  GridPlan plan;
  plan.cells = Cells::hashed;
  plan.slots = uint(std::bit_ceil(std::max<uint64_t>(spheres.size(), least_slots)));
  set_middle(plan, spheres);
  plan.largest_radius = extent.largest;
  plan.equal_radii = extent.largest == extent.smallest;
  plan.side = std::max(2 * extent.largest, float(smallest_side));
  if (extent.largest <= many_octaves * extent.smallest) return plan;
  const uint top = octave(extent.largest);
  plan.first_octave = std::max({octave(extent.smallest), top > 24 ? top - 24 : 0, octave(float(smallest_side))});
  if (top <= plan.first_octave) return plan;
  plan.top_level = top - plan.first_octave;
  plan.largest_radius = std::bit_cast<float>((plan.first_octave + 1) << 23);
  plan.side = 2 * plan.largest_radius;
  const GridParams grid = grid_params(plan);
  plan.levels = 0;
  for (const vec4& sphere : spheres) plan.levels |= 1u << level_of(sphere.w, grid);
  return plan;
}

// Returns the mean number of other spheres in a sphere's slot, for n spheres distributed like these; from a sample.
double occupancy_of(const std::vector<vec4>& spheres, const GridPlan& plan, uint64_t n) {
  const uint64_t m = std::min<uint64_t>(spheres.size(), sample_size);
  if (m < 2) return 0;
  const GridParams grid = grid_params(plan);
  std::vector<uint> slots(m);
  for (uint64_t k = 0; k < m; ++k) slots[k] = slot_of(spheres[k * spheres.size() / m], grid);
  std::ranges::sort(slots);
  double pairs = 0;
  for (uint64_t first = 0, k = 0; k < m; ++k) {
    if (slots[k] != slots[first]) first = k;
    pairs += double(k - first);
  }
  return 2 * pairs / double(m) * double(n - 1) / double(m - 1);
}

// Chooses between both plans for n spheres distributed like these.
GridPlans choose(const GridPlan& dense, const GridPlan& hashed, const std::vector<vec4>& spheres, uint64_t n) {
  GridPlans plans{.dense = dense, .hashed = hashed, .chosen = Cells::dense};
  plans.dense_occupancy = occupancy_of(spheres, dense, n);
  plans.hashed_occupancy = occupancy_of(spheres, hashed, n);
  // Each sphere searches the cells of every level, and a hashed cell costs about four times as much as a dense one.
  if (plans.dense_occupancy > 4 * std::popcount(hashed.levels) * (plans.hashed_occupancy + 1))
    plans.chosen = Cells::hashed;
  plans.reason =
      fmt::format("{}: {:.3g} other spheres in a sphere's cell if dense (side {:.3g} m), {:.3g} if hashed ({:.3g} m)",
                  plans.chosen == Cells::dense ? "dense" : "hashed", plans.dense_occupancy, dense.side,
                  plans.hashed_occupancy, hashed.side);
  return plans;
}

}  // namespace

GridPlans plan_grids(const std::vector<vec4>& spheres) {
  const uint64_t n = spheres.size();
  const Extent extent = extent_of(spheres);
  const GridPlan dense = dense_plan(extent, n);
  if (double(extent.largest) > huge_radius)
    return {.dense = dense,
            .hashed = dense,
            .light = dense,
            .dense_occupancy = double(n),
            .hashed_occupancy = double(n),
            .reason = "dense: the largest radius leaves one cell"};
  GridPlans plans = choose(dense, hashed_plan(spheres, extent), spheres, n);
  plans.smallest_radius = extent.smallest;
  if (extent.largest > 2 * extent.smallest) plans.octaves = octaves_of(spheres);
  plans.light = light_plan(dense, extent, plans.octaves, n);
  return plans;
}

GridPlans plan_grids_anew(const GridPlans& before, const std::vector<vec4>& sample, uint64_t n) {
  Extent extent = extent_of(sample);
  extent.largest = before.dense.largest_radius;
  if (double(extent.largest) > huge_radius) return before;
  GridPlan hashed = before.hashed;
  set_middle(hashed, sample);
  extent.smallest = before.smallest_radius;
  GridPlans plans = choose(dense_plan(extent, n), hashed, sample, n);
  plans.smallest_radius = before.smallest_radius;
  plans.octaves = before.octaves;
  plans.light = light_plan(plans.dense, extent, plans.octaves, n);
  return plans;
}

BucketPlan plan_buckets(uint64_t spheres, uint slots, uint least_buckets) {
  const auto ranges = [=](uint shift) { return (slots >> shift) + 1; };
  uint shift = std::bit_width(CELLS_PER_BUCKET) - 1;
  while (shift > 0 && (ranges(shift) < least_buckets || spheres > spheres_per_bucket * ranges(shift))) --shift;
  const uint buckets = ranges(shift);
  if (buckets <= BUCKETS_AT_MOST && spheres <= SPLIT_TILE * SORT_BLOCK) return {shift, buckets, ONE_PARENT};
  uint parent = shift + uint(std::bit_width(buckets)) / 2;
  while (ranges(parent) > BUCKETS_AT_MOST) ++parent;
  return {shift, buckets, parent};
}

GridParams grid_params(const GridPlan& plan) {
  const double fades_within = OCCLUSION_RADII * std::max(double(plan.largest_radius), 0x1p-30);
  const float cells_per_metre = 1 / plan.side;
  const double scale = double(cells_per_metre) * (1 + 0x1p-19);
  const double margin = coordinate_margin(std::max({plan.size[0], plan.size[1], plan.size[2]}));
  return {.origin_x = plan.origin[0],
          .origin_y = plan.origin[1],
          .origin_z = plan.origin[2],
          .cells_per_metre = cells_per_metre,
          .largest_radius = plan.largest_radius,
          .reach_scale = float(scale),
          .reach_offset = float(scale * double(plan.largest_radius) + margin),
          .occlusion_fade = plan.equal_radii ? float(1 / (fades_within * fades_within)) : 0,
          .cells_x = plan.size[0],
          .cells_y = plan.size[1],
          .cells_z = plan.size[2],
          .cell_slots = plan.slots,
          .hash_mask = plan.cells == Cells::hashed ? plan.slots - 1 : 0,
          .first_octave = plan.first_octave,
          .top_level = plan.top_level,
          .levels = plan.levels};
}

}  // namespace spherepair
