// SPDX-License-Identifier: MIT
#include "common/backend/swept_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "common/scene/contact_scene.h"
#include "common/shared/anchor.h"
#include "common/shared/contact/skin.h"
#include "common/shared/swept.h"

namespace spherepair {
namespace {

bool finite(const vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

Scene scene_of_paths(uint64_t n) {
  Scene scene{.name = "paths"};
  scene.positions.resize(n);
  return scene;
}

void find_equal_radii(Scene& scene) {
  scene.equal_radii =
      std::ranges::all_of(scene.positions, [&](const vec4& s) { return s.w == scene.positions.front().w; });
}

// Returns the speed along y on the step's path. Where the step would end below the plane, these methods repeat it with
// the velocity reversed.
template <typename Real>
float straight_speed(MotionMethod method, float radius, Real y, Real v, MotionParams m) {
  const Real dt = widened(m.dt, y);
  const Real speed = method == MotionMethod::symplectic ? snapped(plus(v, constant(m.gravity_dt, y))) : v;
  const bool falls = method == MotionMethod::paper || method == MotionMethod::paper_clamp;
  const Real end = falls ? advance(y, speed, dt, constant(m.half_gravity_dt2, y)) : drift(y, speed, dt);
  return nearest(below_plane(end, radius, m.plane) ? turned(v, m) : speed);
}

template <typename Real>
bool ends_above(float radius, Real y, Real v, MotionParams m) {
  const Real zero = widened(0.0f, y);
  return !below_plane(glide(Moving<Real>{zero, y, zero, zero, v, zero, radius}, m).y, radius, m.plane);
}

// Says how a path that bounces continues, for a sphere at this height and speed along y.
template <typename Real>
float kind_of_impact(MotionMethod method, float radius, Real y, Real v, MotionParams m) {
  if (ends_above(radius, y, v, m)) return PATH_FLIGHT;
  if (method == MotionMethod::impact_linear) return PATH_ONE_BOUNCE;
  return below_plane(y, radius, m.plane) && below(widened(0.0f, y), v) ? -nearest(v) : PATH_BOUNCES;
}

template <typename Real>
float kind_of_anchor(const MotionState& state, uint64_t i, Real y, Real v, MotionParams m) {
  const vec4& start = state.anchors[i];
  const Real speed = load_real<Real>(state.flights, i);
  const bool from_below = !on_plane(state.since[i]) && below_plane(widened(start.y, y), start.w, m.plane);
  if (!from_below || !below(widened(0.0f, y), speed)) return PATH_BOUNCES;
  const bool above = below(ground(start.w, m.plane, y), y);  // the plane now
  return above && ends_above(start.w, y, v, m) ? PATH_FLIGHT : -nearest(speed);
}

// Returns the velocities of the next drift. The state's momenta are half a step old; each gets the impulses at the
// start of the step, as leapfrog adds them.
std::vector<vec4> drift_velocities(const Motion::State& state, const ContactParams& c, const PairLister& list) {
  const std::vector<vec4>& at = state.positions;
  const uint64_t n = at.size();
  Scene grown = scene_of_paths(n);
  for (uint64_t i = 0; i < n; ++i) grown.positions[i] = grown_sphere(at[i], c);
  find_equal_radii(grown);
  std::vector<Push> pushes(n);
  for (const auto& [i, j] : list(grown)) {
    const Push push = push_of_pair(load_body(state.wide, at, i), load_body(state.wide, at, j), c);
    pushes[i].x += push.x, pushes[i].y += push.y, pushes[i].z += push.z;
    pushes[j].x -= push.x, pushes[j].y -= push.y, pushes[j].z -= push.z;
  }
  std::vector<vec4> velocities(n);
#pragma omp parallel for schedule(static) if (n > many_moves)
  for (uint64_t i = 0; i < n; ++i) {
    const Body before = load_body(state.wide, at, i);
    const Body s = kicked(before, pushes[i], push_of_walls(before, false, c), c);
    velocities[i] = velocity_of(speeds_of(s, mobility_of(s.radius, c)), c);
  }
  return velocities;
}

// Returns the sphere around the box that holds the path. 2^-17 covers rounding here and what touch_within adds: 2^-24
// of reaches, and at most 2^-20 of both lengths and reaches. Paths of methods that bounce are taken as they are, other
// paths in the frame of swept.h, in which they are straight.
vec4 around_path(const vec4& s, const vec4& v, const MotionParams& m) {
  const double start[3] = {double(s.x), double(s.y), double(s.z)}, speed[3] = {double(v.x), double(v.y), double(v.z)};
  const double seconds = double(m.dt), pull = v.w == PATH_STRAIGHT ? 0 : gravity_of(m);
  std::array<double, 3> low, high;
  for (const size_t k : {0u, 2u}) std::tie(low[k], high[k]) = std::minmax({start[k], start[k] + speed[k] * seconds});
  PathPart part = first_part(s, v, m);
  double wander = part.wander;
  low[1] = high[1] = part.y;
  for (;;) {
    const double time = part.end - part.begin, begin = part.y - pull * part.begin * part.begin / 2;
    const double end = part.y + (part.v + part.lift * time / 2) * time - pull * part.end * part.end / 2;
    const double sagitta = (pull - part.lift) * time * time / 8;  // above the chord
    low[1] = std::min({low[1], begin, end});
    high[1] = std::max({high[1], begin + sagitta, end + sagitta});
    if (!(part.end < seconds)) break;
    part = next_part(part, s, v, m);
    wander = std::max(wander, part.wander);
  }
  float centre[3];
  double square = 0;
  for (size_t k = 0; k < 3; ++k) {
    centre[k] = float((low[k] + high[k]) / 2);
    const double side = std::max(high[k] - double(centre[k]), double(centre[k]) - low[k]);
    square += side * side;
  }
  const double radius = (double(s.w) + std::sqrt(square) + wander + part.rounding) * (1 + 0x1p-17);
  return {centre[0], centre[1], centre[2], float(radius)};
}

}  // namespace

std::vector<vec4> path_velocities(const Motion::State& state, const MotionState& saved, MotionOptions motion,
                                  const Params& params, const PairLister& list) {
  if (motion.method == MotionMethod::leapfrog) return drift_velocities(state, params.contact, list);
  std::vector<vec4> velocities = state.velocities;
  const uint64_t n = velocities.size();
  const MotionParams& m = params.motion;
  with_real(motion.precision, [&](auto kind) {
    using Real = decltype(kind);
#pragma omp parallel for schedule(static) if (n > many_moves)
    for (uint64_t i = 0; i < n; ++i) {
      const float radius = state.positions[i].w;
      vec4& v = velocities[i];
      Real y = widened(state.positions[i].y, Real{}), speed = widened(v.y, Real{});
      if (!state.wide.empty()) y = load_real<Real>(state.wide, n + i), speed = load_real<Real>(state.wide, 4 * n + i);
      v.w = PATH_STRAIGHT;
      if (motion.method == MotionMethod::anchored)
        v.w = kind_of_anchor(saved, i, y, speed, m);
      else if (motion.method >= MotionMethod::impact_linear)
        v.w = kind_of_impact(motion.method, radius, y, speed, m);
      else
        v.y = straight_speed(motion.method, radius, y, speed, m);
    }
  });
  return velocities;
}

Scene spheres_around_paths(std::span<const vec4> positions, std::span<const vec4> velocities, const MotionParams& m) {
  const uint64_t n = positions.size();
  Scene scene = scene_of_paths(n);
  uint64_t lost = n;
#pragma omp parallel for schedule(static) reduction(min : lost) if (n > many_moves)
  for (uint64_t i = 0; i < n; ++i) {
    scene.positions[i] = around_path(positions[i], velocities[i], m);
    if (!finite(scene.positions[i]) && finite(positions[i])) lost = std::min(lost, i);
  }
  if (lost < n)
    throw std::invalid_argument(
        fmt::format("sphere {} leaves the range of float32 within the next step: give a smaller --dt", lost));
  find_equal_radii(scene);
  return scene;
}

CollideOptions near_options(const CollideOptions& swept) {
  CollideOptions options = swept;
  options.swept = false;
  return options;
}

}  // namespace spherepair
