// SPDX-License-Identifier: MIT
// Times of GLSL and CUDA by method and group size, the cost of a dispatch or launch, the cost of exactness.
#include <fmt/format.h>

#include <algorithm>

#include "bench/tables/study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

Table skipped(const std::string& title) {
  return {title, {{"", "skipped", "", true}}, {{"no device backend is open, so there is nothing to compare"}}, {}};
}

// Unordered pairs that a method has to test.
double candidate_pairs(Method method, uint block, uint64_t n) {
  const auto all = [](double k) { return k * (k - 1) / 2; };
  if (method != Method::collide_group) return all(double(n));
  return double(n / block) * all(block) + all(double(n % block));
}

void methods_rows(Study& study, Table& table, uint64_t n, Method method) {
  std::vector<Task> tasks;
  for (uint block : study.plan.blocks)
    for (const Task& task : study.collide_tasks(method, block)) tasks.push_back(task);
  const std::vector<Samples> samples = study.time("methods", study.paper_scene(n), tasks);
  const size_t devices = study.session.devices().size();
  for (size_t b = 0; b < study.plan.blocks.size(); ++b) {
    const uint block = study.plan.blocks[b];
    const std::vector<Samples> pair(samples.begin() + b * devices, samples.begin() + (b + 1) * devices);
    std::vector<std::string> row = {std::to_string(n), method_name(method), std::to_string(block)};
    for (const Samples& one : pair) {
      row.push_back(time_cell(one));
      row.push_back(format_rate(candidate_pairs(method, block, n) / one.median_seconds()));
    }
    std::ranges::copy(study.compare("methods", pair), std::back_inserter(row));
    table.rows.push_back(row);
  }
}

struct NaiveErrors {
  uint64_t right = 0, missed = 0, extra = 0;
};

// Counts the pairs that the naive float32 test gets wrong in the hardest scene. First checks the exact result against
// the reference.
NaiveErrors naive_errors(Study& study, Configuration configuration, const SceneOptions& scene) {
  study.progress.say(fmt::format("exactness: {} on {}", label(configuration), scene.name));
  const Configuration reference = reference_for(study.session, configuration.options, scene.n);
  const StepResult expected = run_step(study.session, reference, true),
                   right = run_step(study.session, configuration, true);
  require_equal(study.session, {scene, 0}, reference, expected, configuration, right);
  configuration.options.exact = false;
  const StepResult naive = run_step(study.session, configuration, true);
  std::vector<Pair> missed, extra;
  std::ranges::set_difference(*right.pairs, *naive.pairs, std::back_inserter(missed));
  std::ranges::set_difference(*naive.pairs, *right.pairs, std::back_inserter(extra));
  return {right.pairs->size(), missed.size(), extra.size()};
}

std::vector<NaiveErrors> all_naive_errors(Study& study, const std::vector<Configuration>& all) {
  SceneOptions options = study.paper_scene(2 * study.plan.grazing_pairs);
  options.name = "grazing";
  const Scene scene = make_scene(options);
  for (const auto& backend : study.session.backends()) backend->upload(scene);
  for (const Configuration& configuration : all)
    study.session.comparisons.plan(configuration.backend->info().name, Comparisons::sets, 1);
  std::vector<NaiveErrors> errors;
  for (const Configuration& configuration : all) errors.push_back(naive_errors(study, configuration, options));
  return errors;
}

std::vector<Configuration> exactness_configurations(const Study& study) {
  std::vector<Configuration> configurations;
  for (const Configuration& one : all_configurations(study.session, study.plan.methods, {study.plan.table_block}))
    if (!one.backend->info().on_host || one.options.method != Method::collide_group) configurations.push_back(one);
  return configurations;
}

}  // namespace

std::vector<Table> make_methods(Study& study) {
  const std::vector<Backend*> devices = study.session.devices();
  const std::string title = "GLSL and CUDA per method and group size, random scene, one collision step";
  if (devices.empty()) return {skipped(title)};
  Table table{title, {{"", "n", ""}, {"", "method", "", true}, {"", "group", "size"}}, {}, {}};
  for (Backend* device : devices) {
    const std::string group = device->info().name + (device->info().software ? " in SOFTWARE" : "");
    table.columns.push_back({group, "median", "ms"});
    table.columns.push_back({group, "pairs", "1/s"});
  }
  add_contest_columns(table, study.session);
  for (uint64_t n : study.plan.method_sizes)
    for (Method method : device_methods())
      if (is_wanted(study.plan, method)) methods_rows(study, table, n, method);
  table.notes = {"pairs: unordered pairs tested per second; collide_group tests only pairs within a group.",
                 "The ratio is the median of the rounds' ratios of two turns in a row. A difference is stated only if "
                 "its interval "
                 "is on one side of 1."};
  return {table};
}

std::vector<Table> make_overhead(Study& study) {
  const std::vector<Backend*> devices = study.session.devices();
  const std::string title = "An empty kernel of one group: time per dispatch or launch";
  if (devices.empty()) return {skipped(title)};
  Table table{title, {{"", "back to back", "launches"}}, {}, {}};
  for (Backend* device : devices) {
    table.columns.push_back({device->info().name, "median", "us"});
    table.columns.push_back({device->info().name, "min", "us"});
  }
  add_contest_columns(table, study.session);
  for (uint64_t launches : {1, 10, 100, 1000}) {
    std::vector<Contender> contenders;
    for (Backend* device : devices)
      contenders.push_back({.label = fmt::format("{} launch_empty {}", device->info().name, launches),
                            .backend = device,
                            .step =
                                [launches](Backend& b) {
                                  for (uint64_t k = 0; k < launches; ++k) b.launch_empty(1);
                                  b.finish();
                                },
                            .contest = "launch_empty"});
    const std::vector<Samples> samples =
        study.time_unchecked("overhead", contenders, {{"work", "empty"}, {"launches_per_step", launches}});
    std::vector<std::string> row = {std::to_string(launches)};
    for (const Samples& one : samples) {
      row.push_back(time_cell(one, 1e6 / double(launches)));
      row.push_back(format_us(minimum(one.seconds) / double(launches)));
    }
    std::ranges::copy(study.compare("overhead", samples), std::back_inserter(row));
    table.rows.push_back(row);
  }
  table.notes = {
      "The host waits for the device after this many launches: the first row is a round trip, the last the rate."};
  return {table};
}

std::vector<Table> make_exactness(Study& study) {
  Table times{"Cost of the exact predicate, random scene",
              {{"", "n", ""},
               {"", "configuration", "", true},
               {"median", "naive", "ms"},
               {"median", "exact", "ms"},
               {"", "exact/naive", "times", true}},
              {},
              {}};
  Table wrong{
      "Pairs that the exact predicate corrects, grazing scene",
      {{"", "configuration", "", true}, {"", "right", "pairs"}, {"", "missed", "naive"}, {"", "extra", "naive"}},
      {},
      {}};
  const std::vector<Configuration> all = exactness_configurations(study);
  const std::vector<NaiveErrors> errors = all_naive_errors(study, all);
  for (uint64_t n : study.plan.exactness_sizes)
    for (const Configuration& exact : all) {
      Configuration naive = exact;
      naive.options.exact = false;
      const auto samples = study.time("exactness", study.paper_scene(n),
                                      {{Work::collide, naive, "predicate"}, {Work::collide, exact, "predicate"}});
      times.rows.push_back({std::to_string(n), label(exact), time_cell(samples[0]), time_cell(samples[1]),
                            ratio_text(contest(samples[1], samples[0]))});
    }
  for (size_t k = 0; k < all.size(); ++k)
    wrong.rows.push_back({label(all[k]), std::to_string(errors[k].right), std::to_string(errors[k].missed),
                          std::to_string(errors[k].extra)});
  wrong.notes = {
      fmt::format("grazing: {} of spheres within 8 ulp of touching. missed, extra: pairs that the naive float32 test "
                  "gets wrong there; the exact one was checked against the reference.",
                  counted(study.plan.grazing_pairs, "pair"))};
  return {times, wrong};
}

}  // namespace spherepair
