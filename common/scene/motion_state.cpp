// SPDX-License-Identifier: MIT
#include "common/scene/motion_state.h"

#include "common/scene/contact_scene.h"
#include "common/shared/anchor.h"

namespace spherepair {
namespace {

template <typename Real>
void widen(const Scene& scene, MotionState& state) {
  const uint64_t n = scene.size();
  state.wide.resize(6 * n * sizeof(Real) / sizeof(uint));
#pragma omp parallel for schedule(static)
  for (uint64_t i = 0; i < n; ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    const float values[6] = {at.x, at.y, at.z, v.x, v.y, v.z};
    for (uint64_t k = 0; k < 6; ++k) store_real(state.wide, k * n + i, widened(snap(values[k]), Real{}));
  }
}

template <typename Real>
void anchor_at_start(const Scene& scene, const MotionParams& params, MotionState& state) {
  const uint64_t n = scene.size();
  state.anchors = scene.positions;
  state.flights.resize(2 * n * sizeof(Real) / sizeof(uint));
  state.since.assign(n, 0);
  state.next_event.resize(n);
#pragma omp parallel for schedule(static)
  for (uint64_t i = 0; i < n; ++i) {
    const vec4& v = scene.velocities[i];
    vec4& at = state.anchors[i];
    at = {snap(at.x), snap(at.y), snap(at.z), at.w};
    const Anchor<Real> anchor = {at, snap(v.x), snap(v.z), widened(snap(v.y), Real{}), widened(0.0f, Real{}), 0};
    store_real(state.flights, i, anchor.speed);
    store_real(state.flights, n + i, anchor.age);
    state.next_event[i] = next_event_step(anchor, params);
  }
}

}  // namespace

MotionState initial_state(const Scene& scene, const MotionParams& params) {
  MotionState state;
  if (scene.motion.precision == Precision::fixed) {
    state.wide = fixed_state(scene);
    return state;
  }
  with_real(scene.motion.precision, [&](auto kind) {
    using Real = decltype(kind);
    if (scene.motion.precision != Precision::float32) widen<Real>(scene, state);
    if (scene.motion.method == MotionMethod::anchored) anchor_at_start<Real>(scene, params, state);
  });
  return state;
}

std::vector<vec4> rounded_velocities(const std::vector<uint>& wide, Precision precision, uint64_t n) {
  std::vector<vec4> velocities(n);
  with_real(precision, [&](auto kind) {
    const auto rounded = [&](uint64_t i) { return nearest(load_real<decltype(kind)>(wide, i)); };
    for (uint64_t i = 0; i < n; ++i) velocities[i] = {rounded(3 * n + i), rounded(4 * n + i), rounded(5 * n + i), 0};
  });
  return velocities;
}

}  // namespace spherepair
