// SPDX-License-Identifier: MIT
#include "bench/studies/ablation_work.h"

#include <algorithm>
#include <cmath>

#include "bench/measure/floors.h"
#include "bench/studies/frames.h"
#include "common/scene/camera.h"
#include "common/scene/contact_scene.h"
#include "common/scene/scene_params.h"
#include "common/shared/cell.h"

namespace spherepair {
namespace {

constexpr int steps_counted = 4, pushes_counted = 200;

bool has_contacts(Spheres kind) { return kind == Spheres::pushing || kind == Spheres::at_all_walls; }

Scene drifting(Scene scene) {
  for (vec4& velocity : scene.velocities) velocity = {64, 0, 0, 0};
  scene.gravity = 0;
  return scene;
}

json counts_json(const WorkCounts& before, const WorkCounts& after) {
  const double steps = double(after.steps - before.steps);
  const auto each = [&](uint64_t WorkCounts::*count) { return double(after.*count - before.*count) / steps; };
  return {{"launches", each(&WorkCounts::launches)},     {"sorts", each(&WorkCounts::sorts)},
          {"plans", each(&WorkCounts::plans)},           {"orders_kept", each(&WorkCounts::orders_kept)},
          {"cells_kept", each(&WorkCounts::cells_kept)}, {"graphs_replayed", each(&WorkCounts::graphs_replayed)},
          {"waits", each(&WorkCounts::waits)},           {"overlapped", each(&WorkCounts::overlapped)},
          {"lists", each(&WorkCounts::lists)},           {"without_radii", each(&WorkCounts::without_radii)}};
}

// Means per step: the spheres tested against the plane, and the spheres that bounced.
json plane_json(bool event_driven, Motion& motion, const Scene& scene) {
  uint64_t tested = 0, bounced = 0;
  for (int k = 0; k < steps_counted; ++k) {
    const MotionState before = motion.save();
    motion.move();
    const MotionState after = motion.save();
    for (uint64_t i = 0; i < scene.size(); ++i) {
      tested += before.next_event[i] <= (event_driven ? after.steps : NO_EVENT - 1u);
      bounced += before.since[i] != after.since[i];
    }
  }
  return {{"plane_tests", double(tested) / steps_counted}, {"bounces", double(bounced) / steps_counted}};
}

json push_json(bool keeps, Backend& backend) {
  backend.keep_near_pairs(keeps);
  const uint64_t before = backend.work_counts().steps;
  for (int k = 0; k < pushes_counted; ++k) backend.move();
  return {{"lists", double(backend.work_counts().steps - before) / pushes_counted}};
}

}  // namespace

std::function<void(Backend&)> step_of(const Ablation& ablation, bool on) {
  const Reads reads = on ? Reads::nothing : ablation.reads_off;
  switch (ablation.work) {
    case AblationWork::copy:
      return [kind = on ? PeakRate::copy : PeakRate::words](Backend& backend) { peak_rates_of(backend).launch(kind); };
    case AblationWork::bounce:
      return [on](Motion& motion) { motion.set_event_driven(on), motion.move(); };
    case AblationWork::walls:
      return [](Motion& motion) { motion.move(); };
    case AblationWork::push:
      return [on](Motion& motion) { motion.keep_near_pairs(on), motion.move(); };
    default:
      return [reads, options = on ? ablation.on : ablation.off,
              moves = ablation.spheres == Spheres::drifting](Backend& backend) {
        if (moves) backend.move();
        if (reads == Reads::nothing) return backend.enqueue_collide(options);
        backend.collide(options);
        if (reads == Reads::counts) backend.counts();
      };
  }
}

SceneOptions options_of(Spheres kind, const SceneOptions& uniform) {
  SceneOptions options = uniform;
  if (kind == Spheres::falling) {
    options.name = "random";
    options.motion = {MotionMethod::anchored, Precision::float32};
  }
  if (has_contacts(kind)) options.name = "gas";
  return options;
}

Scene scene_of(Spheres kind, const SceneOptions& uniform) {
  Scene made = make_scene(options_of(kind, uniform));
  if (kind == Spheres::in_cell_order) return in_cell_order(std::move(made));
  if (has_contacts(kind)) choose_contacts(made, {.law = ContactLaw::spring});
  made.contact.tests_all_walls = kind == Spheres::at_all_walls;
  return kind == Spheres::drifting ? drifting(std::move(made)) : made;
}

bool moves(Spheres kind) { return kind != Spheres::random && kind != Spheres::in_cell_order; }

void start(Motion& motion, Spheres kind, const Scene& scene) {
  motion.upload(scene);
  if (kind != Spheres::drifting && kind != Spheres::falling) return;
  const Bounds bounds = bounds_of(scene.positions);
  const double seconds = kind == Spheres::drifting ? (bounds.high[0] - bounds.low[0]) / 64 : 1;
  for (double left = std::ceil(seconds / double(scene.dt)); left > 0; --left) motion.move();
}

json work_per_step(const Ablation& ablation, bool on, Backend& backend, const Scene& scene) {
  const auto step = step_of(ablation, on);
  if (ablation.work == AblationWork::copy || ablation.work == AblationWork::walls) return json::object();
  if (ablation.work == AblationWork::bounce) return plane_json(on, backend, scene);
  if (ablation.work == AblationWork::push) return push_json(on, backend);
  const WorkCounts before = backend.work_counts();
  for (int k = 0; k < steps_counted; ++k) step(backend);
  json work = counts_json(before, backend.work_counts());
  backend.collide(on ? ablation.on : ablation.off);
  work["left_to_exact_stages"] = backend.collisions().deferred;
  return work;
}

}  // namespace spherepair
