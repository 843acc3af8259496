// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace spherepair {

// Counts what must not fall into a timed sample, since the backend was opened.
struct Preparations {
  uint64_t captures = 0;      // graphs of launches, captured and instantiated
  uint64_t compilations = 0;  // programs compiled and linked; kernels loaded by their first launch
  uint64_t allocations = 0;   // of device memory, and of OpenGL's buffers and images
  auto operator<=>(const Preparations&) const = default;
  Preparations operator+(const Preparations& other) const {
    return {captures + other.captures, compilations + other.compilations, allocations + other.allocations};
  }
  Preparations operator-(const Preparations& other) const {
    return {captures - other.captures, compilations - other.compilations, allocations - other.allocations};
  }
};

}  // namespace spherepair
