// SPDX-License-Identifier: MIT
#include "tests/oracle/paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/shared/swept.h"

namespace spherepair {

OraclePath path_of(const Scene& scene, const vec4& at, const vec4& velocity, bool one) {
  const Float dt = scene.dt, pull = -Float(scene.gravity), level = Float(scene.plane) + at.w, v = velocity.y;
  const Float height = at.y - level, above = std::max(height, Float(0)), end = height + v * dt - pull * dt * dt / 2;
  OraclePath path{at.x, at.z, velocity.x, velocity.z, at.w, 0, {{0, at.y, v, pull}}};
  if (end >= 0) return path;
  path.flights[0].y = level + above;
  if (height < 0 && !one) path.wander = std::max(v, Float(0)) * dt;  // as high as that at most
  const Float speed = std::sqrt(v * v + 2 * pull * above);
  Float time = one ? dt * above / (above - end) : v < 0 ? 2 * above / (speed - v) : (v + speed) / pull;
  Float up = std::max(Float(0), one ? pull * time - v : speed) * scene.restitution;
  if (one) path.flights[0].v = v - pull * (dt - time) / 2;
  for (uint bounces = 1; time < dt; ++bounces) {
    if (pull > 0 && 2 * up / pull < dt * 0x1p-50L) up = 0;
    path.flights.push_back({time, level, up, up > 0 ? pull : 0});
    if (bounces == BOUNCES_FOLLOWED + 1 && pull > 0) path.wander += up * up / (2 * pull);
    if (up == 0 || pull == 0) break;
    time += 2 * up / pull;
    up = one ? 0 : up * scene.restitution;
  }
  return path;
}

namespace {

// The least distance within the step: where both fly, by their relative velocity; where one rests, by thirds.
Float least_distance(const OraclePath& a, const OraclePath& b, Float dt) {
  Float least = std::numeric_limits<Float>::max(), begin = 0;
  size_t i = 0, j = 0;
  const auto distance = [&](Float t) {
    const Float x = a.x - b.x + (a.vx - b.vx) * t, z = a.z - b.z + (a.vz - b.vz) * t;
    const Float y = a.height(t, i) - b.height(t, j);
    return std::sqrt(x * x + y * y + z * z);
  };
  const auto search = [&](Float from, Float to) {
    for (int turn = 0; turn < 50; ++turn) {
      const Float left = from + (to - from) / 3, right = to - (to - from) / 3;
      (distance(left) < distance(right) ? to : from) = distance(left) < distance(right) ? right : left;
    }
    least = std::min(least, distance((from + to) / 2));
  };
  while (true) {
    const Float next_a = i + 1 < a.flights.size() ? a.flights[i + 1].begin : dt;
    const Float next_b = j + 1 < b.flights.size() ? b.flights[j + 1].begin : dt;
    const Float end = std::min({next_a, next_b, dt}), quarter = (end - begin) / 4;
    least = std::min({least, distance(begin), distance(end)});
    if (a.flights[i].pull == b.flights[j].pull) {
      const Float p[3] = {a.x - b.x + (a.vx - b.vx) * begin, a.height(begin, i) - b.height(begin, j),
                          a.z - b.z + (a.vz - b.vz) * begin};
      const Float u[3] = {a.vx - b.vx, a.speed(begin, i) - b.speed(begin, j), a.vz - b.vz};
      const Float square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
      if (square > 0)
        least = std::min(least,
                         distance(std::clamp(begin - (p[0] * u[0] + p[1] * u[1] + p[2] * u[2]) / square, begin, end)));
    } else {
      for (int k = 0; k < 4; ++k) search(begin + Float(k) * quarter, begin + Float(k + 1) * quarter);
    }
    if (!(end < dt)) return least;
    i += next_a <= end, j += next_b <= end;
    begin = end;
  }
}

}  // namespace

Expected expect_of_paths(std::span<const OraclePath> paths, Float dt, Float tolerance) {
  Expected expected;
  for (uint i = 0; i < paths.size(); ++i)
    for (uint j = i + 1; j < paths.size(); ++j) {
      const OraclePath &a = paths[i], &b = paths[j];
      const Float reach = a.radius + b.radius, most = reach * (1 + 0x1p-20L) + a.wander + b.wander + tolerance;
      const auto farther = [&](Float p, Float v) { return std::abs(p) > most + std::abs(v) * dt; };
      if (farther(a.x - b.x, a.vx - b.vx) || farther(a.z - b.z, a.vz - b.vz)) continue;
      const Float least = least_distance(a, b, dt);
      if (least < most) expected.may.push_back({i, j});
      if (!(least < reach - tolerance)) continue;
      expected.must.push_back({i, j});
      OraclePath p = a, q = b;
      p.flights.resize(1), q.flights.resize(1);
      expected.behind_bounces += !(least_distance(p, q, dt) < reach);
    }
  return expected;
}

}  // namespace spherepair
