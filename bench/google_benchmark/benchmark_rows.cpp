// SPDX-License-Identifier: MIT
#include "bench/google_benchmark/benchmark_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/io/arguments.h"

namespace spherepair {
namespace {

Contender contender_for(const BenchRow& row) {
  const CollideOptions options = row.options;
  if (!row.work) return {row.name, row.backend, [](Backend& b) { b.launch_empty(1); }};
  const bool moves = *row.work != Work::collide, collides = *row.work != Work::move;
  return {row.name, row.backend, [=](Backend& b) {
            if (moves) b.move();
            if (collides) b.enqueue_collide(options);
          }};
}

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

BenchScene::BenchScene(Session& session, const SceneOptions& options, OnBackend& on_backend)
    : session_(session), options_(options), scene_(make_scene(options)), on_backend_(on_backend) {}

void BenchScene::restore(Backend& backend) {
  if (on_backend_[&backend] == this) return;
  backend.upload(scene_);
  on_backend_[&backend] = this;
}

void BenchScene::check_result(const BenchRow& row) {
  const Configuration configuration{row.backend, row.options},
      reference = reference_for(session_, row.options, options_.n);
  restore(*reference.backend);
  const StepResult expected = run_step(session_, reference, false);
  require_equal(session_, {options_, 0}, reference, expected, configuration, run_step(session_, configuration, false));
}

// Compares one step from the start bit by bit. Both backends have then moved their spheres.
void BenchScene::check_motion(const BenchRow& row) {
  Backend& reference = session_.reference();
  for (Backend* backend : {&reference, row.backend}) {
    on_backend_.erase(backend);
    backend->upload(scene_);
    backend->move();
  }
  require_same_state(session_, {options_, 1}, reference, current_state(reference), *row.backend,
                     current_state(*row.backend));
}

uint64_t BenchScene::check(const BenchRow& row, const Sampling& sampling) {
  const auto known = batches_.find(row.name);
  if (known != batches_.end()) return known->second;
  restore(*row.backend);
  const bool moves = row.work && *row.work != Work::collide, collides = row.work && *row.work != Work::move;
  session_.comparisons.plan(row.backend->info().name, Comparisons::sets, collides);
  session_.comparisons.plan(row.backend->info().name, Comparisons::states, moves);
  if (collides) check_result(row);
  if (moves) check_motion(row);
  session_.comparisons.require_complete();
  return batches_[row.name] = choose_batch(contender_for(row), sampling);
}

double BenchScene::sample(const BenchRow& row, uint64_t batch) {
  restore(*row.backend);
  if (row.work && *row.work != Work::collide) on_backend_.erase(row.backend);
  return time_batch(contender_for(row), batch) / double(batch);
}

}  // namespace spherepair
