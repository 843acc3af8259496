// SPDX-License-Identifier: MIT
#include "bench/check/margin.h"

#include <fmt/format.h>

#include <cmath>

namespace spherepair {

Margin margin_of(vec4 a, vec4 b) {
  using real = long double;
  const real x = real(a.x) - real(b.x), y = real(a.y) - real(b.y), z = real(a.z) - real(b.z);
  const real r = real(a.w) + real(b.w);
  const real s = x * x + y * y + z * z, q = r * r;
  return {decide_exact(a, b).collide, finite_sphere(a) && finite_sphere(b), (s - q) / q * 0x1p24L};
}

std::string describe(const Margin& margin) {
  if (!margin.finite) return "an input is not finite, so the exact result is: apart";
  const std::string size =
      std::isfinite(margin.ulps)
          ? fmt::format("margin |S-Q|/Q = {:.6g} ulp of 2^-24, in long double", double(std::abs(margin.ulps)))
          : std::string("both radii are 0, so there is no margin relative to Q");
  return size + "; the exact integer stages: " + (margin.collide ? "collide" : "apart");
}

}  // namespace spherepair
