// SPDX-License-Identifier: MIT
// Sets of colliding pairs: canonical order, fingerprint, comparison.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

// A pair of sphere indices, first < second. Canonical order is by first, then second.
struct Pair {
  uint first, second;
  auto operator<=>(const Pair&) const = default;
};
static_assert(sizeof(Pair) == sizeof(uvec2));

// A fingerprint that does not depend on the order: the sums modulo 2^64 of two unrelated 64-bit mixes of
// first << 32 | second (hash.h).
struct Fingerprint {
  uint64_t a = 0, b = 0;
  bool operator==(const Fingerprint&) const = default;
};

Fingerprint fingerprint(std::span<const Pair> pairs);

// The first pair, in canonical order, that is in only one of two canonically ordered sets.
struct Difference {
  Pair pair;
  bool in_left;  // else in right
};
std::optional<Difference> first_difference(std::span<const Pair> left, std::span<const Pair> right);

}  // namespace spherepair
