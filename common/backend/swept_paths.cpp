// SPDX-License-Identifier: MIT
#include "common/backend/swept_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spherepair {
namespace {

bool finite(const vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// Gravity moves all alike, so paths are straight as spheres see each other. Centred on the middle of the path, as far
// as its farther end; 2^-17 covers rounding here and the margin of touch_within: at most 2^-20 of both lengths and
// reaches.
vec4 around_path(const vec4& s, const vec4& v, double dt) {
  const double start[3] = {double(s.x), double(s.y), double(s.z)}, speed[3] = {double(v.x), double(v.y), double(v.z)};
  float centre[3];
  double before = 0, behind = 0;  // squared distances of both ends
  for (int k = 0; k < 3; ++k) {
    centre[k] = float(start[k] + speed[k] * (dt / 2));
    const double first = start[k] - double(centre[k]), last = first + speed[k] * dt;
    before += first * first, behind += last * last;
  }
  const double radius = (double(s.w) + std::sqrt(std::max(before, behind))) * (1 + 0x1p-17);
  return {centre[0], centre[1], centre[2], float(radius)};
}

}  // namespace

Scene spheres_around_paths(std::span<const vec4> positions, std::span<const vec4> velocities, float dt) {
  const uint64_t n = positions.size();
  Scene scene{.name = "paths"};
  scene.positions.resize(n);
  uint64_t lost = n;
#pragma omp parallel for schedule(static) reduction(min : lost) if (n > 4096)
  for (uint64_t i = 0; i < n; ++i) {
    scene.positions[i] = around_path(positions[i], velocities[i], double(dt));
    if (!finite(scene.positions[i]) && finite(positions[i])) lost = std::min(lost, i);
  }
  if (lost < n)
    throw std::invalid_argument(
        fmt::format("sphere {} leaves the range of float32 within the next step: give a smaller --dt", lost));
  scene.equal_radii =
      std::ranges::all_of(scene.positions, [&](const vec4& s) { return s.w == scene.positions.front().w; });
  return scene;
}

CollideOptions near_options(const CollideOptions& swept) {
  CollideOptions options = swept;
  options.swept = false;
  return options;
}

}  // namespace spherepair
