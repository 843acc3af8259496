// SPDX-License-Identifier: MIT
#include "bench/studies/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/check/closed_form.h"
#include "bench/check/finite_state.h"
#include "bench/check/step_result.h"
#include "bench/measure/floors.h"

namespace spherepair {
namespace {

SceneOptions scene_options(const PrecisionPlan& plan, MotionOptions motion, int k, uint64_t n) {
  return {.name = "random", .n = n, .seed = plan.seed, .motion = motion, .dt = std::ldexp(1.0f, -k)};
}

ErrorEntry run_for_errors(Motion& motion, const Scene& scene, int k, uint64_t steps) {
  constexpr uint64_t samples = 16;
  ErrorEntry entry{scene.motion, k, motion.info().name, 0, 0, 0, 0, 0};
  motion.upload(scene);
  for (uint64_t step = 1; step <= steps; ++step) {
    motion.move();
    if (step != steps && step % std::max<uint64_t>(steps / samples, 1) != 0) continue;
    const Motion::State state = current_state(motion);
    require_finite(state, step);
    const MotionErrors errors = errors_of(scene, step, state);
    entry.rms_over_time = std::max(entry.rms_over_time, errors.rms);
    entry.largest_over_time = std::max(entry.largest_over_time, errors.largest);
    entry.rms = errors.rms, entry.largest = errors.largest, entry.energy = errors.energy;
  }
  return entry;
}

// After four seconds at the longest time step, the share of bouncing spheres is stationary.
Scene stationary_scene(const PrecisionPlan& plan, Motion& motion) {
  Scene scene = make_scene(scene_options(plan, {MotionMethod::anchored, Precision::float32}, 4, plan.time_n));
  motion.upload(scene);
  for (int step = 0; step < 64; ++step) motion.move();
  Motion::State state = current_state(motion);
  scene.positions = std::move(state.positions);
  scene.velocities = std::move(state.velocities);
  return scene;
}

// Only a bounce increases the upward velocity.
double bouncing_share(Motion& motion, Scene scene, int k) {
  scene.motion = {MotionMethod::anchored, Precision::float32};
  scene.dt = std::ldexp(1.0f, -k);
  motion.upload(scene);
  motion.move();
  const Motion::State after = current_state(motion);
  uint64_t bounced = 0;
  for (uint64_t i = 0; i < scene.size(); ++i) bounced += after.velocities[i].y > scene.velocities[i].y;
  return double(bounced) / double(std::max<uint64_t>(scene.size(), 1));
}

struct Work {
  const char* name;
  std::function<void(Backend&)> step;
};
std::vector<Work> works_of(MotionOptions motion) {
  std::vector<Work> works = {{"move", [](Motion& motion) { motion.move(); }}};
  if (motion.method == MotionMethod::anchored)
    works.push_back({"move and evaluate", [](Motion& motion) { motion.move(), motion.evaluate_positions(); }});
  return works;
}

json motion_json(MotionOptions motion, int k) {
  return {{"method", motion_name(motion.method)},
          {"precision", precision_name(motion.precision)},
          {"k", k},
          {"dt", std::ldexp(1.0, -k)}};
}

}  // namespace

// Counts the cleared count; then position and velocity, read and written, or the wide state with the float32 position
// and velocity written; for `anchored` anchor, velocity, flight, anchor step and next event, read, and the position,
// written.
std::optional<uint64_t> bytes_per_sphere_step(const TimeEntry& entry) {
  const uint64_t wide = entry.motion.precision == Precision::float32 ? 0 : 1;
  if (entry.motion.method != MotionMethod::anchored) return 4 + (wide ? 2 * 48 + 32 : 64);
  if (entry.work == "move") return {};
  return 4 + 32 + 8 * (1 + wide) + 8 + 16;
}

std::vector<ErrorEntry> measure_errors(Session& session, const PrecisionPlan& plan, Progress& progress) {
  std::vector<ErrorEntry> entries;
  for (const MotionOptions& motion : plan.motions)
    for (int k : plan.error_steps) {
      const SceneOptions options = scene_options(plan, motion, k, plan.error_n);
      const Scene scene = make_scene(options);
      const uint64_t steps = uint64_t(std::ldexp(plan.seconds, k));
      progress.say(fmt::format("errors: {} at dt = 2^-{}", motion_label(motion), k));
      const bool in_software = steps <= plan.most_software_steps;
      bool all = true;
      for (const auto& backend : session.backends()) {
        if (backend->info().software && !in_software) {
          all = false;
          continue;
        }
        entries.push_back(run_for_errors(*backend, scene, k, steps));
      }
      if (all) compare_states(session, {options, steps});
    }
  return entries;
}

std::vector<TimeEntry> measure_times(Session& session, const PrecisionPlan& plan, Progress& progress) {
  std::vector<TimeEntry> entries;
  Scene scene = stationary_scene(plan, session.reference());
  for (int k : plan.time_steps) {
    const double bouncing = bouncing_share(session.reference(), scene, k);
    for (const MotionOptions& motion : plan.motions) {
      progress.say(fmt::format("times: {} at dt = 2^-{}", motion_label(motion), k));
      scene.motion = motion;
      scene.dt = std::ldexp(1.0f, -k);
      std::vector<Contender> contenders;
      for (const auto& backend : session.backends()) {
        backend->upload(scene);
        for (int step = 0; step < 3; ++step) backend->move();
        for (const Work& work : works_of(motion))
          contenders.push_back({.label = work.name,
                                .backend = backend.get(),
                                .step = work.step,
                                .contest = work.name,
                                .restart = [&scene](Backend& b) { b.upload(scene); },
                                .working_set = motion_set_bytes(scene.size(), motion)});
      }
      compare_states(session, {scene_options(plan, motion, k, plan.time_n), 3});
      for (Samples& samples : measure(session, contenders, plan.sampling, progress)) {
        const std::string work = samples.label, backend = samples.backend;
        entries.push_back({motion, k, work, backend, scene.size(), bouncing, std::move(samples)});
      }
    }
  }
  return entries;
}

std::vector<CopyEntry> measure_copies(Session& session, const PrecisionPlan& plan, Progress& progress) {
  std::vector<CopyEntry> entries;
  const Scene scene = make_scene(scene_options(plan, {}, 6, plan.time_n));
  std::vector<Contender> contenders;
  for (Backend* device : session.devices()) {
    progress.say("copying on " + device->info().name);
    device->upload(scene);
    peak_rates_of(*device).check(PeakRate::copy);
    contenders.push_back({.label = "copy",
                          .backend = device,
                          .step = [](Backend& backend) { peak_rates_of(backend).launch(PeakRate::copy); },
                          .contest = "copy",
                          .working_set = copy_set_bytes * scene.size()});
  }
  for (Samples& samples : measure(session, contenders, plan.sampling, progress)) {
    const std::string backend = samples.backend;
    entries.push_back({backend, scene.size(), std::move(samples)});
  }
  return entries;
}

json to_json(const ErrorEntry& entry) {
  json out = motion_json(entry.motion, entry.k);
  out.update({{"backend", entry.backend},
              {"rms", entry.rms},
              {"largest", entry.largest},
              {"rms_over_time", entry.rms_over_time},
              {"largest_over_time", entry.largest_over_time},
              {"energy", entry.energy}});
  return out;
}

json to_json(const TimeEntry& entry) {
  json out = motion_json(entry.motion, entry.k);
  const Interval interval = entry.samples.interval();
  const std::optional<uint64_t> bytes = bytes_per_sphere_step(entry);
  out.update({{"work", entry.work},
              {"backend", entry.backend},
              {"n", entry.n},
              {"bouncing", entry.bouncing},
              {"seconds_per_sphere_step", entry.per_sphere()},
              {"low", interval.low / double(entry.n)},
              {"high", interval.high / double(entry.n)},
              {"bytes_per_sphere_step", bytes ? json(*bytes) : json()},
              {"sample", to_json(entry.samples)}});
  return out;
}

json to_json(const CopyEntry& entry) {
  return {{"backend", entry.backend},
          {"n", entry.n},
          {"bytes_per_second", entry.bytes_per_second()},
          {"sample", to_json(entry.samples)}};
}

}  // namespace spherepair
