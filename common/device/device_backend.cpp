// SPDX-License-Identifier: MIT
#include "common/device/device_backend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "common/scene/scene_bounds.h"

namespace spherepair {
namespace {

constexpr uint guard_words = 16;
constexpr uint guard_pattern = 0xA5C3F00Du;
constexpr uint64_t decide_batch = 1u << 20;
constexpr const char* slot_names[SLOT_TOTAL] = {"positions",
                                                "velocities",
                                                "counts",
                                                "summary",
                                                "deferred pairs",
                                                "pairs",
                                                "spheres to decide",
                                                "verdicts",
                                                "cells",
                                                "sphere numbers in buckets",
                                                "spheres in cell order",
                                                "sphere numbers",
                                                "counts in cell order",
                                                "tiles of the scan",
                                                "spheres in buckets",
                                                "buckets",
                                                "visible spheres",
                                                "image",
                                                "tiles of large spheres",
                                                "counts of drawing",
                                                "clusters",
                                                "ages of spheres seen",
                                                "list of clusters",
                                                "pyramid of depths",
                                                "wide state",
                                                "anchors",
                                                "flights",
                                                "steps of the anchors",
                                                "due steps",
                                                "spheres seen",
                                                "visible spheres of every other picture"};

uint64_t ceil_div(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

}  // namespace

std::array<uint, 3> folded(uint64_t groups) {
  const uint64_t y = ceil_div(groups, MAX_GROUPS);
  return {uint(y > 1 ? MAX_GROUPS : std::max<uint64_t>(groups, 1)), uint(std::max<uint64_t>(y, 1)), 1};
}

const char* kernel_name(Kernel kernel) {
#define NAME(name) #name,
  constexpr const char* indices[] = {SPHEREPAIR_KERNELS(NAME)};
#undef NAME
  return indices[int(kernel)];
}

bool takes_view(Kernel kernel) { return std::string_view(kernel_name(kernel)).starts_with("draw_"); }

void DeviceBackend::require_scene(const char* what) const {
  if (!bytes_[SLOT_POSITION])
    throw BackendError(fmt::format("{}: {} needs a scene; call upload first", info().name, what));
}

// How many spheres fit into one binding when these take so many bytes.
uint64_t DeviceBackend::fitting(uint64_t bytes) const {
  const uint64_t room = (largest_binding() - guard_words * sizeof(uint)) / 16 * 16;
  return uint64_t(double(room) / double(bytes) * double(n_));
}

void DeviceBackend::make_buffer(uint slot, uint64_t bytes) {
  bytes = ceil_div(std::max<uint64_t>(bytes, 16), 16) * 16;
  const uint64_t whole = bytes + guard_words * sizeof(uint);
  if (whole > largest_binding()) {
    throw BackendError(fmt::format(
        "{}: {} spheres need {} bytes for the {} ({:.3g} a sphere), but a kernel of this device can bind at "
        "most {}; {} spheres fit",
        info().name, n_, whole, slot_names[slot], double(bytes) / double(n_), largest_binding(), fitting(bytes)));
  }
  if (bytes_[slot] == bytes) return;
  bytes_[slot] = 0;  // none is there should this fail
  allocate(slot, whole);
  bytes_[slot] = bytes;
  const std::vector<uint> guard(guard_words, guard_pattern);
  write(slot, guard.data(), bytes, guard_words * sizeof(uint));
}

void DeviceBackend::check_guards() {
  for (uint slot = 0; slot < SLOT_TOTAL; ++slot) {
    if (!bytes_[slot]) continue;
    std::vector<uint> guard(guard_words);
    read(slot, guard.data(), bytes_[slot], guard_words * sizeof(uint));
    if (std::ranges::any_of(guard, [](uint word) { return word != guard_pattern; })) {
      throw BackendError(
          fmt::format("{}: something was written behind the end of the {}", info().name, slot_names[slot]));
    }
  }
}

void DeviceBackend::upload(const Scene& scene) {
  check_scene(scene);
  finish();
  n_ = scene.size();
  make_buffer(SLOT_POSITION, n_ * sizeof(vec4));
  make_buffer(SLOT_VELOCITY, n_ * sizeof(vec4));
  make_buffer(SLOT_COUNT, n_ * sizeof(uint));
  make_buffer(SLOT_SUMMARY, SUMMARY_SLOTS * SUMMARY_WORDS * sizeof(uint));
  make_buffer(SLOT_DEFERRED, std::max<uint64_t>(n_, 4096) * sizeof(uvec2));
  make_buffer(SLOT_PAIR, std::max<uint64_t>(n_, 4096) * sizeof(uvec2));
  make_buffer(SLOT_SPHERES, 16);
  make_buffer(SLOT_VERDICT, 16);
  write(SLOT_POSITION, scene.positions.data(), 0, n_ * sizeof(vec4));
  write(SLOT_VELOCITY, scene.velocities.data(), 0, n_ * sizeof(vec4));
  equal_radii_ = scene.equal_radii;
  motion_ = scene.motion;
  unmovable_ = why_unmovable(scene);
  constants_ = {scene_params(scene, false), scene_params(scene, true)};
  params_ = constants_[true];
  params_.n = uint(n_);
  plans_ = plan_grids(scene.positions);
  watch_ = PlanWatch(scene, plans_);
  work_ = {.plans = 1};
  moves_to_wait_ = moves_waited_ = 0;
  planned_.reset();
  cell_order_.reset();
  order_ = Order::scene;
  cleared_ = collided_ = cells_built_ = counts_sorted_ = false;
  resolved_in_step_.clear();
  view_ = {};
  clustered_.reset();
  moved_ = seen_known_ = false;
  image_current_ = false;
  images_kept_ = 0;
  write_state(initial_state(scene, params_));
}

// A thread for every sphere, and at least one for every word of the summary, which the same kernels clear.
std::array<uint, 3> DeviceBackend::per_sphere_groups() const {
  return folded(ceil_div(std::max<uint64_t>(n_, SUMMARY_SLOTS * SUMMARY_WORDS), SERVICE_BLOCK));
}

void DeviceBackend::launch_clear(Order order) {
  const uint64_t threads = std::max<uint64_t>(n_, SUMMARY_SLOTS * SUMMARY_WORDS);
  launch({Kernel::clear, SERVICE_BLOCK, {}, folded(ceil_div(threads, SERVICE_BLOCK * SPHERES_PER_SORTER)), order},
         params_);
}

std::vector<uint> DeviceBackend::numbers_in_cell_order() {
  std::vector<uint> numbers(n_);
  if (!index_in_w_) {
    read(SLOT_ID, numbers.data(), 0, n_ * sizeof(uint));
    return numbers;
  }
  std::vector<vec4> sorted(n_);
  read(SLOT_SORTED, sorted.data(), 0, n_ * sizeof(vec4));
  for (uint64_t k = 0; k < n_; ++k) numbers[k] = float_bits(sorted[k].w);
  return numbers;
}

std::vector<uint> DeviceBackend::counts() {
  finished_summary();
  std::vector<uint> counts(n_);
  read(count_slot(order_), counts.data(), 0, n_ * sizeof(uint));
  if (order_ != Order::cells) return counts;
  const std::vector<uint> numbers = numbers_in_cell_order();
  std::vector<uint> by_number(n_);
  for (uint64_t k = 0; k < n_; ++k) by_number[numbers[k]] = counts[k];
  return by_number;
}

std::vector<Pair> DeviceBackend::pairs() {
  if (!options_.want_pairs)
    throw BackendError(fmt::format("{}: no pair list was asked for; set want_pairs", info().name));
  const uint64_t count = collisions().pairs;
  if (count > std::numeric_limits<uint>::max())
    throw BackendError(
        fmt::format("{}: {} pairs collide, but a list holds 2^32 - 1 at most; ask for the numbers without the list",
                    info().name, count));
  return read_pairs(count);
}

std::vector<Pair> DeviceBackend::read_pairs(uint64_t count) {
  std::vector<Pair> pairs(count);
  read(SLOT_PAIR, pairs.data(), 0, count * sizeof(Pair));
  std::ranges::sort(pairs);
  return pairs;
}

std::vector<uint> DeviceBackend::decide(std::span<const vec4> spheres) {
  const uint64_t total = spheres.size() / 2;
  std::vector<uint> verdicts(total);
  make_buffer(SLOT_SPHERES, std::min(total, decide_batch) * 2 * sizeof(vec4));
  make_buffer(SLOT_VERDICT, std::min(total, decide_batch) * sizeof(uint));
  Params params = scene_params(Scene{}, true);
  for (uint64_t first = 0; first < total; first += decide_batch) {
    const uint64_t count = std::min(decide_batch, total - first);
    params.pairs_to_decide = uint(count);
    write(SLOT_SPHERES, &spheres[2 * first], 0, count * 2 * sizeof(vec4));
    launch({Kernel::decide, SERVICE_BLOCK, {}, folded(ceil_div(count, SERVICE_BLOCK))}, params);
    read(SLOT_VERDICT, &verdicts[first], 0, count * sizeof(uint));
  }
  return verdicts;
}

void DeviceBackend::launch_empty(uint groups) { launch({Kernel::empty, SERVICE_BLOCK, {}, folded(groups)}, params_); }

}  // namespace spherepair
