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

// Bounce by bounce until the step ends, or flights last less than a part in 2^50 of it. `one`: impact_linear. From
// below the plane it flies on if that ends above, and else is put onto the plane.
OraclePath path_of(const Scene& scene, const vec4& at, const vec4& velocity, bool one);

// What a swept search has to find, and what it may find besides: what comes as near as rounding and halvings go.
struct Expected {
  std::vector<Pair> must, may;
  uint64_t behind_bounces = 0;  // of `must`: that flights without the plane do not bring together
};

// `tolerance`: in metres, of what rounding decides.
Expected expect_of_paths(std::span<const OraclePath> paths, Float dt, Float tolerance);

}  // namespace spherepair
