// SPDX-License-Identifier: MIT
// Sorts spheres into cell order on the CPU.
#pragma once

#include <span>
#include <vector>

#include "common/cpu/search/cpu_grid_simd.h"
#include "common/scene/host_buffer.h"

namespace spherepair {

// Consecutive places that one task of the search takes.
struct Chunk {
  uint first, last;
};

class CellSort {
 public:
  explicit CellSort(const GridSimd& simd) : simd_(simd) {}

  // Sorts the spheres by slot_of, in two passes: first into buckets of consecutive slots, so that the second pass stays
  // in the cache. radii: keep the radii in cell order, too.
  void sort(std::span<const vec4> spheres, const GridParams& g, bool radii, int threads);

  CellOrder order() const {
    return {x_.data(), y_.data(), z_.data(), radii_ ? radius_.data() : nullptr, id_.data(), begin_.data()};
  }
  // Divides all places into chunks of about equal work, several for each thread.
  std::vector<Chunk> chunks(int threads) const;

 private:
  struct Bucket {
    uint first, last;  // places
    uint64_t work;     // estimate
  };

  void plan(uint64_t n, const GridParams& g);
  void count_buckets(std::span<const vec4> spheres, const GridParams& g, int threads);
  void place_buckets();
  void fill_buckets(std::span<const vec4> spheres, const GridParams& g, int threads);
  void order_bucket(uint number, const GridParams& g);

  // Runs act(k, slot) for each sphere k from `first` to before `last`.
  template <typename Act>
  void for_slots(const vec4* spheres, const float* radii, uint64_t first, uint64_t last, const GridParams& g,
                 Act act) const;

  const GridSimd& simd_;
  bool radii_ = false;
  uint64_t n_ = 0, slots_ = 0, blocks_ = 0;
  uint shift_ = 0;
  std::vector<uint> cursor_;     // [block][bucket]: place of the block's next sphere in the bucket
  std::vector<Bucket> buckets_;  // 2^shift slots each
  Buffer<vec4> split_;           // spheres by bucket, with their index in w
  Buffer<float> split_radius_;
  Buffer<float> x_, y_, z_, radius_;
  Buffer<uint> id_, begin_;
};

}  // namespace spherepair
