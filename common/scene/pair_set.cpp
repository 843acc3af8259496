// SPDX-License-Identifier: MIT
#include "common/scene/pair_set.h"

#include <algorithm>

#include "common/shared/hash.h"

namespace spherepair {

Fingerprint fingerprint(std::span<const Pair> pairs) {
  Fingerprint sum;
  for (const Pair& pair : pairs) {
    sum.a += pair_mix_a(pair.first, pair.second);
    sum.b += pair_mix_b(pair.first, pair.second);
  }
  return sum;
}

std::optional<Difference> first_difference(std::span<const Pair> left, std::span<const Pair> right) {
  const auto [l, r] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
  if (l == left.end() && r == right.end()) return std::nullopt;
  const bool in_left = r == right.end() || (l != left.end() && *l < *r);
  return Difference{in_left ? *l : *r, in_left};
}

}  // namespace spherepair
