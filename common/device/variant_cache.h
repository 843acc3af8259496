// SPDX-License-Identifier: MIT
// Caches compiled kernels by group size and variant. Every launch looks up its kernel, by number, because a map by name
// takes longer than a dispatch.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "common/device/launch.h"

namespace spherepair {

template <typename Compiled>
class VariantCache {
 public:
  // Returns the kernel. On first use `compile` makes it, as a std::unique_ptr<Compiled>.
  template <typename Compile>
  const Compiled& get(Kernel kernel, uint block, const Variant& variant, Compile compile) {
    std::vector<Entry>& entries = entries_[size_t(kernel)];
    for (const Entry& entry : entries)
      if (entry.block == block && entry.variant == variant) return *entry.compiled;
    entries.push_back({block, variant, compile()});
    ++compiled_;
    return *entries.back().compiled;
  }
  uint64_t compiled() const { return compiled_; }

 private:
  struct Entry {
    uint block;
    Variant variant;
    std::unique_ptr<Compiled> compiled;
  };
  std::array<std::vector<Entry>, kernel_count> entries_;  // few for each kernel
  uint64_t compiled_ = 0;
};

}  // namespace spherepair
