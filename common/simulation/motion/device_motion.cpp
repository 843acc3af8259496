// SPDX-License-Identifier: MIT
#include "common/simulation/motion/device_motion.h"

#include <fmt/format.h>

#include <limits>

#include "common/backend/checks.h"
#include "common/scene/scene_params.h"

namespace spherepair {

void DeviceMotion::upload(const Scene& scene, const MotionState* saved) {
  context_.buffers.resize(SLOT_POSITION, scene.size() * sizeof(vec4));
  context_.buffers.resize(SLOT_VELOCITY, scene.size() * sizeof(vec4));
  context_.buffers.write(SLOT_POSITION, scene.positions);
  context_.buffers.write(SLOT_VELOCITY, scene.velocities);
  context_.params.motion = motion_params(scene);
  motion_ = scene.motion;
  unmovable_ = why_unmovable(scene, saved ? Origin::resumed : Origin::start);
  write_state(saved ? *saved : initial_state(scene, context_.params.motion));
  current_ = motion_.method != MotionMethod::anchored;
  evaluated_ = !saved || current_;
  moved_ = saved != nullptr;
}

// Writes the method's state. Buffers that it does not need shrink to a few bytes.
void DeviceMotion::write_state(const MotionState& state) {
  const bool fixed = motion_.precision == Precision::fixed;
  visit_parts(state, [&](uint slot, const char*, const auto& part) {
    const bool kept = slot != SLOT_WIDE || !fixed;
    context_.buffers.resize(slot, kept ? part.size() * sizeof(part[0]) : 0);
    if (kept) context_.buffers.write(slot, part);
  });
  for (uint64_t k = 0; k < 3; ++k) {
    std::vector<Axis> axis(fixed ? context_.n : 0);
    for (uint64_t i = 0; i < axis.size(); ++i)
      axis[i] = {load_real<int64_t>(state.wide, k * context_.n + i),
                 load_real<int64_t>(state.wide, (3 + k) * context_.n + i)};
    context_.buffers.resize(uint(SLOT_AXIS + k), axis.size() * sizeof(Axis));
    context_.buffers.write(uint(SLOT_AXIS + k), axis);
  }
  steps_ = state.steps;
}

// Reads the wide state. `fixed` stores it axis by axis.
std::vector<uint> DeviceMotion::read_wide() {
  if (motion_.precision != Precision::fixed)
    return context_.buffers.read<uint>(SLOT_WIDE, 6 * context_.n * real_words(motion_.precision));
  std::vector<uint> wide(12 * context_.n);
  for (uint64_t k = 0; k < 3; ++k) {
    const std::vector<Axis> axis = context_.buffers.read<Axis>(uint(SLOT_AXIS + k), context_.n);
    for (uint64_t i = 0; i < axis.size(); ++i) {
      store_real(wide, k * context_.n + i, axis[i].position);
      store_real(wide, (3 + k) * context_.n + i, axis[i].momentum);
    }
  }
  return wide;
}

void DeviceMotion::launch(Kernel kernel, bool whole_state, bool clear_results) {
  context_.params.motion.clear_results = clear_results;  // hardly ever changes, so the search need not resend it
  Params params = context_.params;
  params.motion.steps_done = steps_;
  params.motion.whole_state = whole_state;
  const auto groups = kernel == Kernel::bounce ? folded(context_.n / (SERVICE_BLOCK * SPHERES_PER_BOUNCER) + 1)
                                               : groups_per_sphere(context_);
  context_.launch({.kernel = kernel,
                   .block = SERVICE_BLOCK,
                   .variant = {.motion = motion_},
                   .groups = groups,
                   .unused = clear_results ? slots::none : slots::count | slots::summary},
                  params);
}

void DeviceMotion::require_movable() const {
  if (!unmovable_.empty()) throw std::invalid_argument(unmovable_);
}

void DeviceMotion::begin_step() {
  require_movable();
  context_.moved();
  moved_ = true;
}

bool DeviceMotion::step(bool clear_results) {
  begin_step();
  if (motion_.method != MotionMethod::anchored) {
    launch(Kernel::move, false, clear_results);
    return clear_results;
  }
  check_steps(context_.name(), steps_++);
  launch(Kernel::bounce, !event_driven_, clear_results);
  evaluated_ = current_ = false;
  return false;
}

void DeviceMotion::leave_steps_to_search() {
  require_movable();
  if (motion_ != MotionOptions{MotionMethod::paper, Precision::float32})
    throw std::invalid_argument(
        fmt::format("{}: the persistent kernel moves spheres by paper float32, not by {}: choose that motion, or take "
                    "steps one by one",
                    context_.name(), motion_label(motion_)));
  context_.moved();
  moved_ = true;
}

bool DeviceMotion::evaluate_positions() {
  if (evaluated_) return false;
  launch(Kernel::evaluate_positions, false, true);
  evaluated_ = true;
  return true;
}

void DeviceMotion::evaluate_state() {
  if (current_) return;
  launch(Kernel::evaluate_positions, true, false);
  evaluated_ = current_ = true;
}

Motion::State DeviceMotion::state() {
  Motion::State state{context_.buffers.read<vec4>(SLOT_POSITION, context_.n), {}, {}};
  const bool in_buffer = motion_.precision == Precision::float32 || motion_.precision == Precision::fixed;
  if (in_buffer) state.velocities = context_.buffers.read<vec4>(SLOT_VELOCITY, context_.n);
  if (motion_.precision == Precision::float32) return state;
  state.wide = read_wide();
  if (!in_buffer) state.velocities = rounded_velocities(state.wide, motion_.precision, context_.n);
  return state;
}

MotionState DeviceMotion::save() {
  MotionState saved;
  saved.steps = steps_;
  saved.wide = state().wide;
  if (motion_.method == MotionMethod::anchored) {
    saved.anchors.resize(context_.n);
    saved.flights.resize(2 * context_.n * real_words(motion_.precision));
    saved.since.resize(context_.n);
    saved.next_event.resize(context_.n);
  }
  visit_parts(saved, [&](uint slot, const char*, auto& part) {
    if (slot != SLOT_WIDE) context_.buffers.read(slot, part.data(), 0, part.size() * sizeof(part[0]));
  });
  return saved;
}

}  // namespace spherepair
