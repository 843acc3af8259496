// SPDX-License-Identifier: MIT
// Paths of spheres within a step in long double, bounce by bounce, and which of them touch.
#pragma once

#include <span>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

using Float = long double;

struct Flight {
  Float begin, y, v, pull;  // pull: 0 at rest
};

// A sphere's centre within the step: straight along x and z, flights along y.
struct OraclePath {
  Float x, z, vx, vz, radius, wander = 0;
  std::vector<Flight> flights;
  Float height(Float t, size_t k) const {
    const Flight& f = flights[k];
    return f.y + f.v * (t - f.begin) - f.pull * (t - f.begin) * (t - f.begin) / 2;
  }
  Float speed(Float t, size_t k) const { return flights[k].v - flights[k].pull * (t - flights[k].begin); }
};

// The path, bounce by bounce until the step ends or flights last less than 2^-50 of it. `one`: impact_linear. A sphere
// below the plane flies on if it ends above, and else is put onto the plane.
OraclePath path_of(const Scene& scene, const vec4& at, const vec4& velocity, bool one);

// The pairs that a swept search must find, and those that it may also find: paths as near as the errors of rounding and
// halving.
struct Expected {
  std::vector<Pair> must, may;
  uint64_t behind_bounces = 0;  // pairs of `must` that would not meet without the plane
};

// tolerance: metres by which rounding may decide.
Expected expect_of_paths(std::span<const OraclePath> paths, Float dt, Float tolerance);

}  // namespace spherepair
