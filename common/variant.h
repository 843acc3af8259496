// SPDX-License-Identifier: MIT
// What the collision kernels are compiled for; a kernel without a choice of variants ignores it.
#pragma once

#include <compare>

namespace spherepair {

struct Variant {
  bool equal_radii = true;  // loads no radius
  bool listed = false;      // keeps the pairs, not only their number
  auto operator<=>(const Variant&) const = default;
};

}  // namespace spherepair
