// SPDX-License-Identifier: MIT
// The motion of DeviceBackend: the state that a method keeps, one step, and where spheres of `anchored` are.
#include <limits>

#include "common/backend/checks.h"
#include "common/device/device_backend.h"
#include "common/scene/scene_bounds.h"

namespace spherepair {

// Methods that keep less get buffers of a few bytes in the place of these.
void DeviceBackend::write_state(const MotionState& state) {
  visit_parts(state, [&](uint slot, const char*, const auto& part) {
    const uint64_t bytes = part.size() * sizeof(part[0]);
    make_buffer(slot, bytes);
    write(slot, part.data(), 0, bytes);
  });
  steps_ = state.steps;
  evaluated_ = true;
}

void DeviceBackend::launch_motion(Kernel kernel, bool whole_state) {
  Params params = params_;
  params.n = uint(n_);
  params.steps_done = steps_;
  params.whole_state = whole_state;
  params.in_cells = !cleared_;
  const auto groups =
      kernel == Kernel::bounce ? folded(n_ / (SERVICE_BLOCK * SPHERES_PER_BOUNCER) + 1) : per_sphere_groups();
  Launch launching{kernel, SERVICE_BLOCK, {.motion = motion_}, groups};
  if (kernel != Kernel::evaluate_positions && order_ == Order::cells && !cleared_)
    launching.overlaps_previous = overlaps_search();
  launch(launching, params);
}

void DeviceBackend::evaluate_all(bool whole_state) {
  launch_motion(Kernel::evaluate_positions, whole_state);
  evaluated_ = true;
}

void DeviceBackend::evaluate_positions() {
  require_scene("evaluate_positions");
  if (evaluated_) return;
  evaluate_all(false);
  cleared_ = true;
}

// What a collision step is about to read.
void DeviceBackend::prepare_positions() {
  if (!options_.swept) return evaluate_positions();
  check_swept(info().name, options_, motion_);
  if (motion_.method == MotionMethod::anchored) evaluate_all(true);
}

void DeviceBackend::move() {
  require_scene("move");
  if (!unmovable_.empty()) throw std::invalid_argument(unmovable_);
  if (motion_.method == MotionMethod::anchored) {
    check_steps(info().name, steps_++);
    launch_motion(Kernel::bounce, !event_driven_);
    evaluated_ = cleared_ = false;
  } else {
    cleared_ = !counts_sorted_;  // which the next sort makes anew
    launch_motion(Kernel::move, false);
  }
  moved_ = true;
  collided_ = cells_built_ = image_current_ = false;
  cell_order_.reset();
  watch_.moved();
  ++moves_waited_;
  clustered_.reset();
}

Backend::State DeviceBackend::state() {
  require_scene("state");
  if (motion_.method == MotionMethod::anchored) evaluate_all(true);
  State state{std::vector<vec4>(n_), std::vector<vec4>(n_), {}};
  read(SLOT_POSITION, state.positions.data(), 0, n_ * sizeof(vec4));
  if (motion_.precision == Precision::float32) {
    read(SLOT_VELOCITY, state.velocities.data(), 0, n_ * sizeof(vec4));
    return state;
  }
  state.wide.resize(6 * n_ * real_words(motion_.precision));
  read(SLOT_WIDE, state.wide.data(), 0, state.wide.size() * sizeof(uint));
  state.velocities = rounded_velocities(state.wide, motion_.precision, n_);
  return state;
}

MotionState DeviceBackend::save() {
  require_scene("save");
  MotionState saved;
  saved.steps = steps_;
  saved.wide = state().wide;
  if (motion_.method == MotionMethod::anchored) {
    saved.anchors.resize(n_);
    saved.flights.resize(2 * n_ * real_words(motion_.precision));
    saved.since.resize(n_);
    saved.next_event.resize(n_);
  }
  visit_parts(saved, [&](uint slot, const char*, auto& part) {
    if (slot != SLOT_WIDE) read(slot, part.data(), 0, part.size() * sizeof(part[0]));
  });
  return saved;
}

void DeviceBackend::resume(const Scene& scene, const MotionState& saved) {
  upload(scene);
  unmovable_ = why_unmovable(scene, std::numeric_limits<float>::max());
  write_state(saved);
  evaluated_ = motion_.method != MotionMethod::anchored;
  moved_ = true;
}

}  // namespace spherepair
