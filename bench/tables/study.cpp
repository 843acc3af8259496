// SPDX-License-Identifier: MIT
#include "bench/tables/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/io/scene_text.h"
#include "bench/measure/floors.h"

namespace spherepair {
namespace {

uint64_t working_set(const Task& task, const Scene& scene) {
  const uint64_t search = search_set_bytes(scene.size(), task.configuration.options.method, false);
  if (task.work == Work::collide) return search;
  const uint64_t motion = motion_set_bytes(scene.size(), scene.motion);
  return task.work == Work::move || search == 0 ? motion : motion + search - scene.size() * shared_set_bytes;
}

// Spheres that move begin each batch at the scene's start, after a complete search, which the later steps need.
Contender contender_for(const Task& task, const Scene& scene) {
  const CollideOptions options = task.configuration.options;
  const bool moves = task.work != Work::collide, collides = task.work != Work::move;
  Contender contender{.label = label(task),
                      .backend = task.configuration.backend,
                      .step =
                          [=](Backend& b) {
                            if (moves) b.move();
                            if (collides) b.enqueue_collide(options);
                          },
                      .contest = task.contest,
                      .working_set = working_set(task, scene)};
  if (contender.contest.empty()) contender.contest = contender.label.substr(contender.label.find(' ') + 1);
  if (moves)
    contender.restart = [=, &scene](Backend& b) {
      b.upload(scene);
      if (collides) b.collide(options);
    };
  return contender;
}

// The configurations to check. The naive predicate may be wrong by design, so the same configuration is checked with
// the exact one.
std::vector<Configuration> to_check(const std::vector<Task>& tasks) {
  std::vector<Configuration> configurations;
  for (const Task& task : tasks) {
    if (task.work == Work::move) continue;
    Configuration exact = task.configuration;
    exact.options.exact = true;
    const bool known =
        std::ranges::any_of(configurations, [&](const Configuration& one) { return label(one) == label(exact); });
    if (!known) configurations.push_back(exact);
  }
  return configurations;
}

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

}  // namespace

std::string label(const Task& task) {
  if (task.work == Work::move) return task.configuration.backend->info().name + " move";
  const std::string text = label(task.configuration) + (task.configuration.options.exact ? "" : " naive");
  return task.work == Work::step ? text + " + move" : text;
}

SceneOptions Study::paper_scene(uint64_t n) const {
  SceneOptions scene;
  scene.n = n;
  scene.seed = plan.seed;
  return scene;
}

std::vector<Task> Study::collide_tasks(Method method, uint block, bool exact) const {
  std::vector<Task> tasks;
  for (Backend* device : session.devices())
    tasks.push_back({Work::collide, {device, {.method = method, .block = block, .exact = exact}}});
  return tasks;
}

void Study::upload(const SceneOptions& options) {
  const Scene scene = make_scene(options);
  for (const auto& backend : session.backends()) backend->upload(scene);
}

// Plans to compare every configuration except the references, and the states of every backend except the reference.
void Study::plan_comparisons(const SceneOptions& scene, const std::vector<Configuration>& configurations,
                             uint64_t steps) {
  for (const auto& backend : session.backends())
    if (backend.get() != &session.reference())
      session.comparisons.plan(backend->info().name, Comparisons::states, steps);
  for (const Configuration& one : configurations)
    if (label(one) != label(reference_for(session, one.options, scene.n)))
      session.comparisons.plan(one.backend->info().name, Comparisons::sets, steps);
}

// Compares all results in the current state, set by set.
void Study::check_step(const SceneOptions& scene, const std::vector<Configuration>& configurations, uint64_t step) {
  const ComparisonPoint point{scene, step};
  const uint64_t state = require_same_states(session, point);
  std::map<std::string, std::vector<Configuration>> sets;
  for (const Configuration& one : configurations) sets[set_name(one.options)].push_back(one);
  for (const auto& [name, members] : sets) {
    const Configuration reference = reference_for(session, members.front().options, scene.n);
    const StepResult expected = run_step(session, reference, false);
    references_[name] = label(reference);
    EqualityEntry entry{scene, name, {label(reference)}, {}};
    for (const Configuration& one : members) {
      if (label(one) == label(reference)) continue;
      require_equal(session, point, reference, expected, one, run_step(session, one, false));
      entry.configurations.push_back(label(one));
    }
    entry.checkpoints.push_back(
        {step, expected.totals.pairs, expected.totals.colliding_spheres, expected.totals.fingerprint, state});
    equality.push_back(std::move(entry));
  }
}

// Checks at the start and after each step.
void Study::check_steps(const SceneOptions& scene, const std::vector<Configuration>& configurations, uint64_t steps) {
  plan_comparisons(scene, configurations, steps);
  upload(scene);
  for (uint64_t step = 0; step < steps; ++step) {
    if (step > 0)
      for (const auto& backend : session.backends()) backend->move();
    check_step(scene, configurations, step);
  }
  session.comparisons.require_complete();
}

StepResult Study::check(const SceneOptions& scene, const std::vector<Configuration>& configurations) {
  check_steps(scene, configurations, 1);
  return run_step(session, configurations.front(), false);
}

std::vector<Samples> Study::time(const std::string& table, const SceneOptions& scene, const std::vector<Task>& tasks) {
  progress.say(fmt::format("{}: checking {} n = {}", table, scene_label(scene), scene.n));
  const bool moves = std::ranges::any_of(tasks, [](const Task& task) { return task.work != Work::collide; });
  check_steps(scene, to_check(tasks), moves ? 2 : 1);
  std::vector<Contender> contenders;
  const Scene made = make_scene(scene);
  for (const Task& task : tasks) contenders.push_back(contender_for(task, made));
  std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
  for (size_t k = 0; k < tasks.size(); ++k) record(table, scene, tasks[k], samples[k]);
  return samples;
}

std::vector<Samples> Study::time_unchecked(const std::string& table, const std::vector<Contender>& contenders,
                                           const json& meta) {
  std::vector<Samples> samples = measure(session, contenders, plan.sampling, progress);
  for (const Samples& one : samples) {
    json row = {{"table", table}};
    row.update(meta);
    row.update(to_json(one));
    measurements.push_back(std::move(row));
  }
  return samples;
}

std::vector<std::string> Study::compare(const std::string& table, std::span<const Samples> samples) {
  std::vector<std::string> cells;
  for (const auto& [device, baseline] : session.contests()) {
    const auto left = std::ranges::find(samples, device->info().name, &Samples::backend);
    const auto right = std::ranges::find(samples, baseline->info().name, &Samples::backend);
    contests.push_back({table, contest(*left, *right)});
    cells.push_back(ratio_text(contests.back().contest));
  }
  return cells;
}

void Study::record(const std::string& table, const SceneOptions& scene, const Task& task, const Samples& samples) {
  constexpr const char* works[] = {"move", "collide", "step"};
  json row = {{"table", table}, {"work", works[size_t(task.work)]}, {"n", scene.n}, {"scene", scene_json(scene)}};
  if (task.work != Work::move) {
    const CollideOptions& options = task.configuration.options;
    row["method"] = method_name(options.method);
    row["block"] = uses_blocks(task.configuration) ? json(options.block) : json(nullptr);
    row["exact"] = options.exact;
    row["first_step_ms"] = number_or_null(session.first_seconds(*task.configuration.backend, options) * 1e3);
    row["checked_against"] = references_.at(set_name(options));
  }
  row.update(to_json(samples));
  measurements.push_back(std::move(row));
}

void add_contest_columns(Table& table, const Session& session) {
  for (const auto& [device, baseline] : session.contests())
    table.columns.push_back({"", device->info().name + "/" + baseline->info().name, "times", true});
}

bool SizeSequence::next() {
  if (at_ == sizes_.size()) return false;
  const uint64_t n = sizes_[at_++];
  if (study_.plan.hardware || last_.empty()) return true;
  const double ratio = double(n) / double(last_n_);
  const double seconds = predict_seconds(last_, std::max(1.0, ratio * ratio), study_.plan.sampling);
  if (seconds <= study_.plan.row_seconds) return true;
  const bool one = at_ == sizes_.size();
  notes_.push_back(fmt::format("n = {}{} left out: {:.0f} s{} on this machine. --full or --n includes {}.", n,
                               one ? " is" : fmt::format(" to {} are", sizes_.back()), seconds, one ? "" : " and more",
                               one ? "it" : "them"));
  at_ = sizes_.size();
  return false;
}

const std::vector<TableKind>& table_kinds() {
  static const std::vector<TableKind> kinds = {
      {"table1", "the paper's Table 1 and our times: plane and pairs", make_table1},
      {"frame_rates", "the same: frames per second and drawing", make_frame_rates},
      {"counts", "numbers of colliding spheres and the paper's ranges", make_counts},
      {"arrangements", "the paper's aligned arrangements of spheres, timed", make_arrangements},
      {"methods", "GLSL against CUDA per method and group size", make_methods},
      {"peak_rates", "peak rates of each device: copying, atomics, multiply-adds", make_peak_rates},
      {"overhead", "the cost of an empty dispatch or launch", make_overhead},
      {"exactness", "the cost of the exact predicate, and what it corrects", make_exactness},
      {"scale", "collide_triangle from small to large n", make_scale},
      {"step", "a whole step: motion, plane, all pairs", make_step},
      {"grid", "the uniform grid against all pairs", make_grid},
      {"equality", "what was compared and found equal", make_equality}};
  return kinds;
}

}  // namespace spherepair
