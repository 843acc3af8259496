// SPDX-License-Identifier: MIT
// Compiled kernels by group size and variant. Each launch looks its kernel up, so by number: a map by name takes longer
// than a dispatch.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "common/device/launch.h"

namespace spherepair {

template <typename Compiled>
class VariantCache {
 public:
  // The kernel, which `compile` makes on its first use: a std::unique_ptr<Compiled>.
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
  std::array<std::vector<Entry>, kernel_count> entries_;  // by kernel, which has few
  uint64_t compiled_ = 0;
};

}  // namespace spherepair
