// SPDX-License-Identifier: MIT
#include "bench/gpu/launch_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/scene_text.h"
#include "bench/measure/floors.h"
#include "bench/studies/study_sampling.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint64_t steps_checked = 6;    // the third and later ones of a graph are replays
constexpr uint64_t steps_counted = 128;  // after those: more than the longest graph holds
constexpr uint64_t steps_enqueued = 64;  // so few that no API's queue is full and the host never waits

std::string name_of(const LaunchPath& path) { return fmt::format("{} {}", path.backend, path.name); }

uint64_t working_set(LaunchWork work, const Scene& scene) {
  if (work == LaunchWork::empty) return 0;
  if (work == LaunchWork::grid) return search_set_bytes(scene.size(), Method::collide_grid, false);
  return motion_set_bytes(scene.size(), scene.motion);  // all pairs read the same bytes again
}

WorkCounts difference(const WorkCounts& after, const WorkCounts& before) {
  WorkCounts made;
  for (uint64_t WorkCounts::*count :
       {&WorkCounts::steps, &WorkCounts::launches, &WorkCounts::waits, &WorkCounts::graphs_replayed,
        &WorkCounts::kernels_replayed, &WorkCounts::overlapped, &WorkCounts::early})
    made.*count = after.*count - before.*count;
  return made;
}

json per_step(const WorkCounts& made) {
  const auto each = [&](uint64_t count) { return double(count) / double(made.steps); };
  return {{"launches", each(made.launches)},
          {"kernels", each(made.launches - made.graphs_replayed + made.kernels_replayed)},
          {"waits", each(made.waits)},
          {"graphs_replayed", each(made.graphs_replayed)},
          {"overlapped", each(made.overlapped)},
          {"early", each(made.early)}};
}

std::string text_of(const WorkCounts& made) {
  return fmt::format("in {}, {}, of which {} are waited for, {} overlap, {} get ready early, and {}",
                     counted(made.steps, "step"), counted(made.launches, "launch", "launches"), made.waits,
                     made.overlapped, made.early, counted(made.graphs_replayed, "replayed graph"));
}

}  // namespace

LaunchStudy::LaunchStudy(Session& session, const LaunchesOptions& options, std::function<void()> write)
    : session_(session), write_(std::move(write)) {
  sampling_ = study_sampling(options.rounds);
  sampling_.software_seconds = 0.01;
  sampling_.longest = 0.1;
}

void LaunchStudy::run(const std::vector<uint64_t>& sizes) {
  uint64_t done = 0;
  measure_size(LaunchWork::empty, sizes.front());
  for (const LaunchWork work : {LaunchWork::all_pairs, LaunchWork::grid})
    for (const uint64_t n : sizes) {
      progress_.reach(done++, 2 * sizes.size());
      measure_size(work, n);
      write_();
    }
}

std::vector<LaunchStudy::Row> LaunchStudy::rows_of(LaunchWork work) const {
  std::vector<Row> found;
  for (const LaunchPath& path : launch_paths())
    if (Backend* backend = session_.find(path.backend); backend && path.has(work))
      found.push_back({&path, backend, {}});
  return found;
}

void LaunchStudy::measure_size(LaunchWork work, uint64_t n) {
  const SceneOptions options = launch_scene(work, n);
  const Scene scene = make_scene(options);
  progress_.say(fmt::format("checking {} of {}", launch_work_name(work), n));
  if (work != LaunchWork::empty) expect(work, scene);
  std::vector<Row> paths = rows_of(work);
  std::erase_if(paths, [&](Row& row) { return !check(row, work, scene, options); });
  if (!paths.empty()) time(paths, work, scene, options);
}

void LaunchStudy::expect(LaunchWork work, const Scene& scene) {
  const Configuration reference = reference_for(session_, {}, scene.size());
  reference.backend->upload(scene);
  for (uint64_t k = 0; work == LaunchWork::all_pairs && k < steps_checked; ++k) reference.backend->move();
  expected_ = run_step(session_, reference, false);
  if (work == LaunchWork::all_pairs) expected_state_ = current_state(*reference.backend);
}

// Whether this device offers the path. Throws DifferenceFound if its results are not the reference's.
bool LaunchStudy::check(Row& row, LaunchWork work, const Scene& scene, const SceneOptions& options) {
  const auto leave_out = [&](const std::string& reason) {
    left_out.push_back(
        fmt::format("{}, {} of {}: {}", name_of(*row.path), launch_work_name(work), scene.size(), reason));
    return false;
  };
  if (row.path->persistent && !row.backend->persistent_steps())
    return leave_out("this device launches no kernel whose groups wait for each other");
  row.backend->upload(scene);
  try {
    run_steps(*row.path, work, *row.backend, steps_checked);
  } catch (const std::invalid_argument& error) {  // an option that this device lacks
    return leave_out(error.what());
  }
  if (work != LaunchWork::empty) require_reference(row, work, options);
  enqueue_steps(*row.path, work, *row.backend, steps_checked);
  row.backend->finish();
  const WorkCounts before = row.backend->work_counts();
  enqueue_steps(*row.path, work, *row.backend, steps_counted);
  row.backend->finish();
  const WorkCounts made = difference(row.backend->work_counts(), before);
  row.work_per_step = per_step(made);
  return row.path->shown(made) || leave_out("its steps go another way here: " + text_of(made));
}

void LaunchStudy::require_reference(const Row& row, LaunchWork work, const SceneOptions& options) {
  const std::string backend = row.backend->info().name;
  const ComparisonPoint point{options, work == LaunchWork::all_pairs ? steps_checked : 0};
  session_.comparisons.plan(backend, Comparisons::sets, 1);
  require_equal(session_, point, reference_for(session_, {}, options.n), expected_,
                {row.backend, launch_options(*row.path, work)}, result_of(*row.backend, false));
  if (work == LaunchWork::all_pairs) {
    session_.comparisons.plan(backend, Comparisons::states, 1);
    require_same_state(session_, point, session_.reference(), expected_state_, *row.backend,
                       current_state(*row.backend));
  }
  session_.comparisons.require_complete();
}

Contender LaunchStudy::contender_for(const Row& row, LaunchWork work, const Scene& scene) const {
  const auto enqueue = [=, path = row.path](Backend& b, uint64_t steps) { enqueue_steps(*path, work, b, steps); };
  Contender contender{.label = fmt::format("{} {} of {}", name_of(*row.path), launch_work_name(work), scene.size()),
                      .backend = row.backend,
                      .step = [=](Backend& b) { enqueue(b, 1); },
                      .contest = "paths",
                      .alternates = true,
                      .working_set = working_set(work, scene)};
  if (row.path->persistent) contender.steps = enqueue;
  if (work == LaunchWork::all_pairs)
    contender.restart = [=, &scene, path = row.path](Backend& b) { b.upload(scene), run_steps(*path, work, b, 1); };
  return contender;
}

// The host's seconds to enqueue a step, without the wait at the end: the median of as many short batches as the study
// has rounds.
double LaunchStudy::enqueuing(const Contender& contender) const {
  std::vector<double> seconds;
  for (int round = 0; round < sampling_.rounds; ++round)
    seconds.push_back(
        time_batch(contender, steps_enqueued, steps_ahead(contender, steps_enqueued), sampling_.clocks).enqueuing /
        double(steps_enqueued));
  return median(seconds);
}

void LaunchStudy::record(const Row& row, LaunchWork work, const SceneOptions& options, const Samples& samples,
                         double enqueuing) {
  const double launches = row.each("launches");
  json entry = {{"table", "launches"},
                {"n", options.n},
                {"scene", scene_json(options)},
                {"work", launch_work_name(work)},
                {"path", row.path->name},
                {"work_per_step", row.work_per_step},
                {"us_per_kernel", 1e6 * samples.median_seconds() / row.each("kernels")},
                {"host_ns_per_step", 1e9 * enqueuing},
                {"host_ns_per_launch", 1e9 * enqueuing / launches}};
  entry.update(to_json(samples));
  measurements.push_back(std::move(entry));
}

// Times all paths in one contest: they share K and take their turns one right after the other.
void LaunchStudy::time(const std::vector<Row>& paths, LaunchWork work, const Scene& scene,
                       const SceneOptions& options) {
  std::vector<Contender> contenders;
  for (const Row& row : paths) contenders.push_back(contender_for(row, work, scene));
  const std::vector<Samples> samples = measure(session_, contenders, sampling_, progress_);
  const auto by_time = [](const Samples& one) { return std::pair(!one.unsteady().empty(), one.median_seconds()); };
  const auto fastest = std::ranges::min_element(samples, {}, by_time);
  for (size_t k = 0; k < paths.size(); ++k) {
    const double host = enqueuing(contenders[k]);
    record(paths[k], work, options, samples[k], host);
    const bool least = &samples[k] == &*fastest, leads = least && samples[k].unsteady().empty();
    rows[work].push_back({std::to_string(options.n), paths[k].path->backend, paths[k].path->name,
                          time_cell(samples[k], 1e6), format_us(samples[k].median_seconds() / paths[k].each("kernels")),
                          format_number(1e9 * host), format_number(1e9 * host / paths[k].each("launches")),
                          samples[k].fixed.empty() ? "-" : format_us(median(samples[k].fixed)),
                          leads   ? "fastest"
                          : least ? "-"
                                  : ratio_text(contest(samples[k], *fastest))});
  }
}

}  // namespace spherepair
