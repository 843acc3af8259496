// SPDX-License-Identifier: MIT
#include "bench/studies/set_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/check/closed_form.h"
#include "bench/check/finite_state.h"
#include "bench/check/missed_contacts.h"
#include "bench/check/step_result.h"
#include "bench/measure/choice.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

constexpr float top_speed = 1;  // of any sphere along an axis, metres per second

SceneOptions scene_options(const SetPlan& plan, MotionOptions motion, int k) {
  return {.name = "random", .n = plan.n, .seed = plan.seed, .motion = motion, .dt = std::ldexp(1.0f, -k)};
}

struct RunResult {
  Backend* backend;
  Motion::State state;
  StepResult result;
};
RunResult run_for_set(Session& session, Backend& backend, const Scene& scene, uint64_t steps) {
  backend.upload(scene);
  for (uint64_t step = 0; step < steps; ++step) backend.move();
  const Configuration configuration = {&backend, {.method = choose_method("", backend)}};
  Motion::State state = current_state(backend);
  require_finite(state, steps);
  return {&backend, std::move(state), run_step(session, configuration, true)};
}

// Runs every backend and compares its set with the first one's. If there is a GPU, only it makes long runs.
MotionSetEntry run_on_all(Session& session, const SetPlan& plan, const Scene& scene, MotionSetEntry entry,
                          const std::vector<Pair>& right) {
  const uint64_t steps = uint64_t(std::ldexp(plan.seconds, entry.k));
  const SceneOptions options = scene_options(plan, entry.motion, entry.k);
  const bool gpu = std::ranges::any_of(session.backends(), [](const auto& b) { return on_hardware(*b); });
  std::optional<RunResult> first;
  for (const auto& backend : session.backends()) {
    if ((first || gpu) && !on_hardware(*backend) && steps > plan.most_software_steps) continue;
    RunResult run = run_for_set(session, *backend, scene, steps);
    entry.backends.push_back(backend->info().name);
    if (!first) {
      first = std::move(run);
      continue;
    }
    session.comparisons.plan(backend->info().name, Comparisons::sets, 1);
    session.comparisons.plan(backend->info().name, Comparisons::states, 1);
    const auto configuration = [&](Backend& b) { return Configuration{&b, {.method = choose_method("", b)}}; };
    require_same_state(session, {options, steps}, *first->backend, first->state, *backend, run.state);
    require_equal(session, {options, steps}, configuration(*first->backend), first->result, configuration(*backend),
                  run.result);
  }
  session.comparisons.require_complete();
  entry.found = set_error(*first->result.pairs, right);
  entry.whole = set_error(state_pairs(scene, first->state), right);
  entry.rms = errors_of(scene, steps, first->state).rms;
  return entry;
}

// Times a step with the exact predicate, then with the naive one.
std::array<Samples, 2> time_predicates(Session& session, const SetPlan& plan, Configuration configuration,
                                       Progress& progress) {
  std::vector<Contender> contenders;
  for (bool exact : {true, false}) {
    CollideOptions options = configuration.options;
    options.exact = exact;
    contenders.push_back({.label = fmt::format("{} {}", label(configuration), exact ? "exact" : "naive"),
                          .backend = configuration.backend,
                          .step = [options](Search& search) { search.enqueue_collide(options); },
                          .contest = "predicate"});
    session.collide(*configuration.backend, options);
  }
  std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
  return {std::move(samples[0]), std::move(samples[1])};
}

json set_json(const SetError& error) {
  return {{"right", error.right}, {"missed", error.missed}, {"extra", error.extra}};
}

}  // namespace

Scene drifting_scene(const SetPlan& plan, MotionOptions motion, int k, float offset) {
  Scene scene = make_scene(scene_options(plan, motion, k));
  const auto hashed = [&](uint64_t index) {
    return top_speed * (float(splitmix64(splitmix64(plan.seed) + index) >> 40) * 0x1p-23f - 1);
  };
  for (uint64_t i = 0; i < scene.size(); ++i) {
    scene.positions[i].x += offset;
    scene.positions[i].z += offset;
    scene.velocities[i].x = hashed(2 * i);
    scene.velocities[i].z = hashed(2 * i + 1);
  }
  return scene;
}

std::vector<MotionSetEntry> measure_motion_sets(Session& session, const SetPlan& plan, Progress& progress) {
  std::vector<std::pair<int, float>> cases;  // k, offset
  for (int k : plan.steps) cases.push_back({k, 0});
  for (float offset : plan.offsets) cases.push_back({plan.far_step, offset});
  std::vector<MotionSetEntry> entries;
  for (const auto& [k, offset] : cases) {
    const uint64_t steps = uint64_t(std::ldexp(plan.seconds, k));
    const std::vector<Pair> right = closed_form_pairs(drifting_scene(plan, {}, k, offset), steps);
    for (const MotionOptions& motion : plan.motions) {
      progress.say(fmt::format("sets: {} at dt = 2^-{}, offset {} m", motion_label(motion), k, offset));
      const Scene scene = drifting_scene(plan, motion, k, offset);
      entries.push_back(run_on_all(session, plan, scene, {motion, k, offset, {}, {}, {}, 0}, right));
    }
  }
  return entries;
}

std::vector<StorageEntry> measure_storage(const SetPlan& plan, Progress& progress) {
  const Scene scene = drifting_scene(plan, {}, plan.far_step, 0);
  const std::vector<Pair> right = stored_pairs(scene, 0, Precision::float64);
  std::vector<StorageEntry> entries;
  for (float offset : plan.offsets)
    for (Precision precision : {Precision::float32, Precision::compensated, Precision::float64}) {
      progress.say(fmt::format("sets: stored as {}, offset {} m", precision_name(precision), offset));
      entries.push_back({precision, offset, set_error(stored_pairs(scene, double(offset), precision), right)});
    }
  return entries;
}

std::vector<NaiveEntry> measure_naive(Session& session, const SetPlan& plan, Progress& progress) {
  std::vector<NaiveEntry> entries;
  for (const char* name : {"uniform", "far", "grazing"}) {
    const Scene scene = make_scene({.name = name, .n = plan.naive_n, .seed = plan.seed});
    for (const auto& backend : session.backends()) {
      progress.say(fmt::format("exactness: {} on {}", name, backend->info().name));
      backend->upload(scene);
      Configuration configuration = {backend.get(), {.method = choose_method("", *backend)}};
      const StepResult exact = run_step(session, configuration, true);
      configuration.options.exact = false;
      const SetError error = set_error(*run_step(session, configuration, true).pairs, *exact.pairs);
      auto [exact_samples, naive_samples] = time_predicates(session, plan, configuration, progress);
      entries.push_back({method_name(backend->choice(configuration.options).method), name, scene.size(), error,
                         std::move(exact_samples), std::move(naive_samples)});
    }
  }
  return entries;
}

std::vector<ContactEntry> measure_contacts(Session& session, const SetPlan& plan, Progress& progress) {
  std::vector<ContactEntry> entries;
  for (double distance : plan.distances) {
    const Scene scene = passing_scene(plan.passing, distance, plan.seed);
    for (const auto& backend : session.backends()) {
      progress.say(fmt::format("contacts: {} radius sums per step on {}", distance, backend->info().name));
      entries.push_back({backend->info().name, distance, plan.passing, missed_pairs(*backend, scene, distance, false),
                         missed_pairs(*backend, scene, distance, true)});
    }
  }
  return entries;
}

double ContactEntry::expected() const { return expected_miss_share(distance) * double(pairs); }
double ContactEntry::deviation() const { return std::sqrt(expected() * (1 - expected_miss_share(distance))); }

json to_json(const MotionSetEntry& entry) {
  json out = {{"method", motion_name(entry.motion.method)},
              {"precision", precision_name(entry.motion.precision)},
              {"k", entry.k},
              {"dt", std::ldexp(1.0, -entry.k)},
              {"offset", entry.offset},
              {"backends", entry.backends}};
  out.update(set_json(entry.found));
  out.update({{"whole_missed", entry.whole.missed}, {"whole_extra", entry.whole.extra}, {"rms", entry.rms}});
  return out;
}

json to_json(const StorageEntry& entry) {
  json out = {{"precision", precision_name(entry.precision)}, {"offset", entry.offset}};
  out.update(set_json(entry.error));
  return out;
}

json to_json(const NaiveEntry& entry) {
  json out = {{"backend", entry.exact.backend}, {"method", entry.method}, {"scene", entry.scene}, {"n", entry.n}};
  out.update(set_json(entry.error));
  out.update({{"exact", to_json(entry.exact)}, {"naive", to_json(entry.naive)}});
  return out;
}

json to_json(const ContactEntry& entry) {
  return {{"backend", entry.backend},
          {"distance", entry.distance},
          {"pairs", entry.pairs},
          {"missed", entry.missed},
          {"expected", entry.expected()},
          {"deviation", entry.deviation()},
          {"swept_missed", entry.swept_missed}};
}

}  // namespace spherepair
