// SPDX-License-Identifier: MIT
#include "bench/check/closed_form.h"

#include <algorithm>
#include <cmath>

#include "bench/check/quad.h"

namespace spherepair {
namespace {

struct Vertical {
  Quad height, speed;  // metres above the plane; m/s upwards
};

// Height and speed of a sphere, `time` after it left the plane upwards with `speed`.
Vertical bounced(Quad time, Quad speed, const Quad& gravity, const Quad& e) {
  if (gravity == 0) return {speed * time, speed};
  if (e == 1) {
    const Quad flight = 2 * speed / gravity;
    if (flight == 0) return {0, 0};
    time -= flight * floor(time / flight);
  } else {
    if (time >= 2 * speed / (gravity * (1 - e))) return {0, 0};
    while (time >= 2 * speed / gravity) {
      time -= 2 * speed / gravity;
      speed *= e;
    }
  }
  return {time * (speed - gravity * time / 2), speed - gravity * time};
}

// A sphere below the plane starts on it; gravity > 0 points downwards.
Vertical vertical(Quad height, const Quad& speed, const Quad& time, const Quad& gravity, const Quad& e) {
  if (height < 0) height = 0;
  const Quad impact = sqrt(speed * speed + 2 * gravity * height);
  const bool falls = gravity > 0 || speed < 0;
  const Quad until = !falls ? time : speed < 0 ? 2 * height / (impact - speed) : (speed + impact) / gravity;
  if (!falls || time < until) return {height + time * (speed - gravity * time / 2), speed - gravity * time};
  return bounced(time - until, e * impact, gravity, e);
}

// The height of a sphere that lies on the plane.
Quad ground_of(const Scene& scene, uint64_t i) { return Quad(scene.plane) + Quad(scene.positions[i].w); }

template <typename Real>
long double long_double(const std::vector<uint>& wide, uint64_t i) {
  const Real value = load_real<Real>(wide, i);
  if constexpr (std::is_same_v<Real, Two>) return (long double)(value.hi) + value.lo;
  if constexpr (std::is_same_v<Real, double>) return value;
  return 0;
}

}  // namespace

ExactState exact_state(const Motion::State& state, MotionOptions motion, uint64_t i) {
  const vec4 &at = state.positions[i], &v = state.velocities[i];
  ExactState exact = {at.x, at.y, at.z, v.x, v.y, v.z};
  if (motion.precision == Precision::float32) return exact;
  with_real(motion.precision, [&](auto kind) {
    for (uint64_t k = 0; k < 6; ++k) exact[k] = long_double<decltype(kind)>(state.wide, k * state.positions.size() + i);
  });
  return exact;
}

QuadPoint closed_form_position(const Scene& scene, uint64_t i, uint64_t steps) {
  const vec4 &start = scene.positions[i], &velocity = scene.velocities[i];
  const Quad ground = ground_of(scene, i), time = Quad(scene.dt) * Quad(steps);
  const Vertical now =
      vertical(Quad(start.y) - ground, Quad(velocity.y), time, -Quad(scene.gravity), Quad(scene.restitution));
  return {Quad(start.x) + Quad(velocity.x) * time, ground + now.height, Quad(start.z) + Quad(velocity.z) * time};
}

MotionError error_of(const Scene& scene, uint64_t i, uint64_t steps, const ExactState& state) {
  const QuadPoint wanted = closed_form_position(scene, i, steps);
  Quad square = 0;
  for (size_t axis = 0; axis < 3; ++axis) square += (wanted[axis] - state[axis]) * (wanted[axis] - state[axis]);
  const Quad gravity = -Quad(scene.gravity), ground = ground_of(scene, i), start = scene.velocities[i].y;
  const auto energy = [&](const Quad& speed, const Quad& above) { return speed * speed / 2 + gravity * above; };
  const Quad before = energy(start, scene.positions[i].y - ground), now = energy(state[4], state[1] - ground);
  return {double(sqrt(square)), before > 0 ? double((now - before) / before) : 0.0};
}

MotionErrors errors_of(const Scene& scene, uint64_t steps, const Motion::State& state) {
  MotionErrors errors;
  double squares = 0;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const MotionError error = error_of(scene, i, steps, exact_state(state, scene.motion, i));
    squares += error.position * error.position;
    errors.largest = std::max(errors.largest, error.position);
    if (std::abs(error.energy) > std::abs(errors.energy)) errors.energy = error.energy;
  }
  if (scene.size()) errors.rms = std::sqrt(squares / double(scene.size()));
  return errors;
}

}  // namespace spherepair
