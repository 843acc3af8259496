// SPDX-License-Identifier: MIT
// Sorts spheres into cell order: by buckets, by counting, or by a library. Each way also writes where the cells begin,
// and clears counts and totals.
#pragma once

#include "common/device/context.h"

namespace spherepair {

class SphereSort {
 public:
  // index_in_w: sphere indices take the place of the radii, which are all equal.
  SphereSort(DeviceContext& context, const CollideOptions& options, bool index_in_w);

  void run();

 private:
  void by_counting();
  void by_buckets();
  void by_library();
  void split(uint shift, uint parent_shift, uint first_bucket, Order from, Order to);
  void split_tiles(uint shift, uint buckets);
  void split_twice(uint shift, uint buckets, uint parent_shift);
  void scan(uint table);
  void clear(uint64_t bucket_words);
  void launch(Kernel kernel, uint block, uint64_t groups);

  DeviceContext& context_;
  const CollideOptions& options_;
  bool index_in_w_;
  uint slots_;  // of the table of cells
  Variant cells_;
};

}  // namespace spherepair
