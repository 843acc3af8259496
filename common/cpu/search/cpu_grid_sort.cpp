// SPDX-License-Identifier: MIT
#include "common/cpu/search/cpu_grid_sort.h"

#include <algorithm>
#include <bit>

#include "common/backend/cpu_team.h"

namespace spherepair {
namespace {

constexpr uint64_t spheres_per_bucket = 4096, most_buckets = 4096, spheres_per_block = 32768, most_blocks = 256;
constexpr uint batch = 1024;  // number of slots computed at once
constexpr uint64_t chunks_per_thread = 16, least_work = 16384;
constexpr uint64_t own_work = 8, cell_work = 1;  // cost of a sphere alone, and with each sphere of its cell

}  // namespace

template <typename Act>
void CellSort::for_slots(const vec4* spheres, const float* radii, uint64_t first, uint64_t last, const GridParams& g,
                         Act act) const {
  uint slots[batch];
  for (uint64_t at = first; at < last; at += batch) {
    const uint count = uint(std::min<uint64_t>(batch, last - at));
    simd_.find_slots(spheres + at, radii ? radii + at : nullptr, count, g, slots);
    for (uint k = 0; k < count; ++k) act(at + k, slots[k]);
  }
}

void CellSort::sort(std::span<const vec4> spheres, const GridParams& g, bool radii, int threads) {
  threads = team_of(spheres.size() / spheres_per_bucket, threads);
  radii_ = radii;
  plan(spheres.size(), g);
  count_buckets(spheres, g, threads);
  place_buckets();
  fill_buckets(spheres, g, threads);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (size_t bucket = 0; bucket < buckets_.size(); ++bucket) order_bucket(uint(bucket), g);
}

void CellSort::plan(uint64_t n, const GridParams& g) {
  n_ = n;
  slots_ = g.cell_slots;
  const uint64_t wanted = std::clamp<uint64_t>(n / spheres_per_bucket, 1, most_buckets);
  shift_ = uint(std::bit_width((slots_ - 1) / wanted));
  buckets_.assign(((slots_ - 1) >> shift_) + 1, {});
  blocks_ = std::clamp<uint64_t>(n / spheres_per_block, 1, most_blocks);
  cursor_.assign(blocks_ * buckets_.size(), 0);
  split_.resize(n);
  if (radii_) split_radius_.resize(n), radius_.resize(n);
  x_.resize(n), y_.resize(n), z_.resize(n), id_.resize(n);
  begin_.resize(slots_ + 1);
}

void CellSort::count_buckets(std::span<const vec4> spheres, const GridParams& g, int threads) {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (uint64_t block = 0; block < blocks_; ++block) {
    uint* count = &cursor_[block * buckets_.size()];
    for_slots(spheres.data(), nullptr, block * n_ / blocks_, (block + 1) * n_ / blocks_, g,
              [&](uint64_t, uint slot) { ++count[slot >> shift_]; });
  }
}

// Turns counts into first places: bucket by bucket, and block by block within a bucket.
void CellSort::place_buckets() {
  uint place = 0;
  for (size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    buckets_[bucket].first = place;
    for (uint64_t block = 0; block < blocks_; ++block) {
      uint& entry = cursor_[block * buckets_.size() + bucket];
      const uint count = entry;
      entry = place;
      place += count;
    }
    buckets_[bucket].last = place;
  }
}

void CellSort::fill_buckets(std::span<const vec4> spheres, const GridParams& g, int threads) {
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (uint64_t block = 0; block < blocks_; ++block) {
    uint* cursor = &cursor_[block * buckets_.size()];
    for_slots(spheres.data(), nullptr, block * n_ / blocks_, (block + 1) * n_ / blocks_, g, [&](uint64_t i, uint slot) {
      const vec4& s = spheres[i];
      const uint place = cursor[slot >> shift_]++;
      split_[place] = {s.x, s.y, s.z, bits_float(uint(i))};
      if (radii_) split_radius_[place] = s.w;
    });
  }
}

// Sorts a bucket by slot. begin_[slot + 1] first counts the slot's spheres, then is the place of its next sphere. After
// the last sphere that is where the next slot begins.
void CellSort::order_bucket(uint number, const GridParams& g) {
  Bucket& bucket = buckets_[number];
  const uint64_t first_slot = uint64_t(number) << shift_,
                 last_slot = std::min(first_slot + (uint64_t(1) << shift_), slots_);
  const float* radii = radii_ ? split_radius_.data() : nullptr;
  uint* next = begin_.data() + 1;
  if (number == 0) begin_[0] = 0;
  std::fill(next + first_slot, next + last_slot, 0u);
  for_slots(split_.data(), radii, bucket.first, bucket.last, g, [&](uint64_t, uint slot) { ++next[slot]; });
  uint place = bucket.first;
  bucket.work = 0;
  for (uint64_t slot = first_slot; slot < last_slot; ++slot) {
    const uint count = next[slot];
    next[slot] = place;
    place += count;
    bucket.work += count * (own_work + cell_work * count);
  }
  for_slots(split_.data(), radii, bucket.first, bucket.last, g, [&](uint64_t k, uint slot) {
    const uint to = next[slot]++;
    const vec4& s = split_[k];
    x_[to] = s.x, y_[to] = s.y, z_[to] = s.z;
    id_[to] = float_bits(s.w);
    if (radii) radius_[to] = radii[k];
  });
}

std::vector<Chunk> CellSort::chunks(int threads) const {
  uint64_t work = 0;
  for (const Bucket& bucket : buckets_) work += bucket.work;
  const uint64_t share = std::max<uint64_t>(work / (chunks_per_thread * uint64_t(threads)), least_work);
  std::vector<Chunk> all;
  uint64_t gathered = 0;
  uint first = 0;
  const auto close = [&](uint last) {
    if (last > first) all.push_back({first, last});
    first = last;
    gathered = 0;
  };
  for (const Bucket& bucket : buckets_) {
    const uint64_t parts = bucket.work / share + 1, spheres = bucket.last - bucket.first;
    for (uint64_t part = 1; part < parts; ++part) close(bucket.first + uint(spheres * part / parts));
    gathered += bucket.work / parts;
    if (gathered >= share) close(bucket.last);
  }
  close(uint(n_));
  return all;
}

}  // namespace spherepair
