// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_motion.h"

#include <fmt/format.h>

#include <limits>

#include "common/backend/checks.h"
#include "common/scene/scene_params.h"
#include "common/shared/motion.h"

namespace spherepair {
void CpuMotion::upload(const Scene& scene) {
  motion_ = scene.motion;
  unmovable_ = why_unmovable(scene);
  params_ = motion_params(scene);
  positions_ = scene.positions;
  velocities_ = scene.velocities;
  kept_ = initial_state(scene, params_);
  contacts_.upload(scene);
  evaluated_ = true;
  state_current_ = motion_.method != MotionMethod::anchored;
}

template <typename Real>
Moving<Real> CpuMotion::load(uint64_t i) const {
  const vec4 &at = positions_[i], &v = velocities_[i];
  if constexpr (std::is_same_v<Real, float>) return {at.x, at.y, at.z, v.x, v.y, v.z, at.w};
  const uint64_t n = positions_.size();
  const auto wide = [&](uint64_t k) { return load_real<Real>(kept_.wide, k * n + i); };
  return {wide(0), wide(1), wide(2), wide(3), wide(4), wide(5), at.w};
}

// Stores a sphere's position; velocity and wide state only if `whole`.
template <typename Real>
void CpuMotion::store(uint64_t i, const Moving<Real>& sphere, bool whole) {
  positions_[i] = {nearest(sphere.x), nearest(sphere.y), nearest(sphere.z), sphere.radius};
  if (!whole) return;
  if constexpr (std::is_same_v<Real, float>) {
    velocities_[i] = {sphere.vx, sphere.vy, sphere.vz, 0};
  } else {
    const Real values[6] = {sphere.x, sphere.y, sphere.z, sphere.vx, sphere.vy, sphere.vz};
    for (uint64_t k = 0; k < 6; ++k) store_real(kept_.wide, k * positions_.size() + i, values[k]);
  }
}

template <typename Real>
void CpuMotion::step_all(int threads) {
  const uint method = uint(motion_.method);
#pragma omp parallel for num_threads(threads) schedule(static) if (positions_.size() > many_moves)
  for (uint64_t i = 0; i < positions_.size(); ++i) store(i, take_step(method, load<Real>(i), params_), true);
}

template <typename Real>
void CpuMotion::bounce_all(int threads) {
  const uint now = event_driven_ ? params_.steps_done : NO_EVENT - 1u;
#pragma omp parallel for num_threads(threads) schedule(static) if (positions_.size() > many_moves)
  for (uint64_t i = 0; i < positions_.size(); ++i) {
    if (now < kept_.next_event[i]) continue;
    const Anchor<Real> anchor = anchor_anew(load_anchor<Real>(i), params_);
    store_real(kept_.flights, i, anchor.speed);
    store_real(kept_.flights, positions_.size() + i, anchor.age);
    kept_.since[i] = anchor.since;
    kept_.next_event[i] = next_event_step(anchor, params_);
  }
}

void CpuMotion::require_movable() const {
  if (!unmovable_.empty()) throw std::invalid_argument(unmovable_);
}

void CpuMotion::move(int threads) {
  require_movable();
  if (contacts_.on()) return contacts_.step(kept_.wide, positions_, velocities_);
  with_real(motion_.precision, [&](auto kind) {
    using Real = decltype(kind);
    if (motion_.method != MotionMethod::anchored) return step_all<Real>(threads);
    check_steps("cpu", kept_.steps);
    params_.steps_done = ++kept_.steps;
    bounce_all<Real>(threads);
    evaluated_ = state_current_ = false;
  });
}

void CpuMotion::evaluate(int threads, bool whole) {
  params_.steps_done = kept_.steps;
  with_real(motion_.precision, [&](auto kind) {
    using Real = decltype(kind);
#pragma omp parallel for num_threads(threads) schedule(static) if (positions_.size() > many_moves)
    for (uint64_t i = 0; i < positions_.size(); ++i) store(i, evaluate_sphere(load_anchor<Real>(i), params_), whole);
  });
  evaluated_ = true;
  state_current_ = whole;
}

const std::vector<vec4>& CpuMotion::positions(int threads) {
  if (!evaluated_) evaluate(threads, false);
  return positions_;
}

void CpuMotion::evaluate_state(int threads) {
  require_sound();
  if (!state_current_) evaluate(threads, true);
}

Motion::State CpuMotion::state() const {
  if (!state_current_) throw BackendError("cpu: the state is that of an earlier step; call evaluate_state");
  if (kept_.wide.empty() || contacts_.on()) return {positions_, velocities_, kept_.wide};
  return {positions_, rounded_velocities(kept_.wide, motion_.precision, positions_.size()), kept_.wide};
}

MotionState CpuMotion::save(int threads) {
  evaluate_state(threads);
  kept_.contact_steps = contacts_.steps();
  return kept_;
}

void CpuMotion::resume(const Scene& scene, const MotionState& saved) {
  unmovable_ = why_unmovable(scene, Origin::resumed);
  kept_ = saved;
  contacts_.follow(saved.contact_steps);
  evaluated_ = state_current_ = motion_.method != MotionMethod::anchored;
}

}  // namespace spherepair
