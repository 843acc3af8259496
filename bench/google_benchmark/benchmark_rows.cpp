// SPDX-License-Identifier: MIT
#include "bench/google_benchmark/benchmark_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"

namespace spherepair {
namespace {

bool moves(const BenchRow& row) { return row.work && *row.work != Work::collide; }
bool collides(const BenchRow& row) { return row.work && *row.work != Work::move; }

}  // namespace

std::vector<BenchRow> bench_rows(Session& session, const std::vector<uint>& blocks) {
  std::vector<BenchRow> rows;
  for (const auto& backend : session.backends()) {
    const std::string& name = backend->info().name;
    const bool on_host = backend->info().on_host;
    const Method method = on_host ? Method::parallel : Method::collide_triangle;
    rows.push_back({name + "/move", backend.get(), Work::move, {}});
    rows.push_back({name + "/step", backend.get(), Work::step, {.method = method}});
    if (!on_host) rows.push_back({name + "/empty", backend.get(), std::nullopt, {}});
  }
  for (const Configuration& configuration : all_configurations(session, all_methods(), blocks)) {
    std::string name = label(configuration);
    std::ranges::replace(name, ' ', '/');
    rows.push_back({name, configuration.backend, Work::collide, configuration.options});
  }
  return rows;
}

std::string parameters_of(const BenchRow& row, const SceneOptions& scene) {
  constexpr const char* works[] = {"move", "collide", "step"};
  const std::string method = row.work && *row.work != Work::move ? method_name(row.options.method) : "none";
  return fmt::format("backend={} work={} method={} scene={}", row.backend->info().name,
                     row.work ? works[size_t(*row.work)] : "empty", method, scene.name);
}

Contender BenchScene::contender_for(const BenchRow& row) {
  Contender contender{.label = row.name, .backend = row.backend, .step = [&row](Backend& b) {
                        if (!row.work) b.launch_empty(1);
                        if (moves(row)) b.move();
                        if (collides(row)) b.enqueue_collide(row.options);
                      }};
  if (!moves(row)) return contender;
  contender.restart = [this, &row](Backend& b) {
    b.upload(scene_);
    if (collides(row)) b.collide(row.options);
  };
  return contender;
}

void BenchScene::check_result(const BenchRow& row) {
  const Configuration configuration{row.backend, row.options},
      reference = reference_for(session_, row.options, options_.n);
  for (Backend* backend : {reference.backend, row.backend}) backend->upload(scene_);
  const StepResult expected = run_step(session_, reference, false);
  require_equal(session_, {options_, 0}, reference, expected, configuration, run_step(session_, configuration, false));
}

// Compares one step from the start bit by bit.
void BenchScene::check_motion(const BenchRow& row) {
  Backend& reference = session_.reference();
  for (Backend* backend : {&reference, row.backend}) {
    backend->upload(scene_);
    backend->move();
  }
  require_same_state(session_, {options_, 1}, reference, current_state(reference), *row.backend,
                     current_state(*row.backend));
}

const BatchPlan& BenchScene::check(const BenchRow& row, const Sampling& sampling) {
  const auto known = plans_.find(row.name);
  if (known != plans_.end()) return known->second;
  session_.comparisons.plan(row.backend->info().name, Comparisons::sets, collides(row));
  session_.comparisons.plan(row.backend->info().name, Comparisons::states, moves(row));
  if (collides(row)) check_result(row);
  if (moves(row)) check_motion(row);
  session_.comparisons.require_complete();
  row.backend->upload(scene_);
  const Contender contender = contender_for(row);
  const Contender* const alone[] = {&contender};
  return plans_[row.name] = plan_batches(alone, sampling);
}

double BenchScene::sample(const BenchRow& row, const BatchPlan& plan, const Sampling& sampling) {
  row.backend->upload(scene_);
  Samples samples;
  samples.plan = plan;
  add_turn(samples, take_turn(contender_for(row), plan, sampling.clocks, order_), 0);
  fit_rounds(samples);
  return samples.seconds.front();
}

}  // namespace spherepair
