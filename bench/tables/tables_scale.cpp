// SPDX-License-Identifier: MIT
// All pairs from small to large n, whole steps, and all measurements of a table.
#include <fmt/format.h>

#include <cmath>

#include "bench/io/scene_text.h"
#include "bench/measure/floors.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

std::vector<Task> scale_tasks(const Study& study) {
  std::vector<Task> tasks = study.collide_tasks(Method::collide_triangle, study.plan.table_block);
  Backend* cpu = study.session.find("cpu");
  if (tasks.empty() && cpu) tasks.push_back({Work::collide, {cpu, {.method = Method::parallel}}});
  return tasks;
}

std::vector<std::string> scale_row(Study& study, const SceneOptions& scene, const std::vector<Task>& tasks,
                                   const std::vector<Samples>& samples, double rate) {
  const double pairs = 0.5 * double(scene.n) * double(scene.n - 1);
  std::vector<std::string> row = {scene_label(scene), std::to_string(scene.n)};
  for (size_t k = 0; k < tasks.size(); ++k) {
    const double per_second = pairs / samples[k].median_seconds();
    row.push_back(ms_of(samples[k]));
    row.push_back(format_rate(per_second));
    if (!on_hardware(*tasks[k].configuration.backend) || std::isnan(rate)) continue;
    row.push_back(format_number(100 * per_second * instructions_per_pair / rate));
  }
  if (samples.size() > 1) row.push_back(study.compare("scale", samples[0], samples[1]));
  return row;
}

json value_of(const json& row, const char* name) { return row.contains(name) ? row.at(name) : json(nullptr); }
std::string number_cell(const json& value, double factor) {
  return value.is_number() ? format_number(value.get<double>() * factor) : "-";
}
std::string ms_cell(const json& value) { return value.is_number() ? format_ms(value.get<double>() / 1e3) : "-"; }

}  // namespace

std::vector<Table> make_scale(Study& study) {
  Table table{"All pairs from small to large n: one collision step, each pair tested once",
              {{"", "scene", "", true}, {"", "n", ""}},
              {},
              {}};
  const double rate = issue_rate(study.session);
  const std::vector<Task> tasks = scale_tasks(study);
  if (tasks.empty()) return {};
  for (const Task& task : tasks) {
    const std::string group = label(task) + (task.configuration.backend->info().software ? " in SOFTWARE" : "");
    table.columns.push_back({group, "median", "ms"});
    table.columns.push_back({group, "pairs", "1/s"});
    if (on_hardware(*task.configuration.backend) && !std::isnan(rate))
      table.columns.push_back({group, "of floor", "%"});
  }
  if (tasks.size() > 1) table.columns.push_back({"", "verdict", "", true});
  std::vector<std::string> left_out;
  for (const char* name : {"random", "uniform"}) {
    SizeSequence sizes(study, study.plan.scale_sizes);
    while (sizes.next()) {
      SceneOptions scene = study.paper_scene(sizes.n());
      scene.name = name;
      const std::vector<Samples> samples = study.time("scale", scene, tasks);
      sizes.measured(samples);
      table.rows.push_back(scale_row(study, scene, tasks, samples, rate));
    }
    for (const std::string& note : sizes.notes()) left_out.push_back(fmt::format("{}: {}", name, note));
  }
  table.notes = {"random: the paper's fixed 20x20x20 box, so the density grows with n; uniform: packing fraction 0.3."};
  if (!std::isnan(rate))
    table.notes.push_back(fmt::format(
        "of floor: share of the issue rate, {:.3g} lane-instructions/s (multiprocessors x 128 lanes x highest "
        "clock), that the pairs take at {} instructions each.",
        rate, instructions_per_pair));
  table.notes.insert(table.notes.end(), left_out.begin(), left_out.end());
  return {table};
}

std::vector<Table> make_step(Study& study) {
  Table table{"A whole step: motion, plane, all pairs, counts and flags; random scene", {{"", "n", ""}}, {}, {}};
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) {
    const bool cpu = backend->info().on_host;
    const Method method = cpu ? Method::parallel : Method::collide_triangle;
    tasks.push_back({Work::step, {backend.get(), {.method = method, .block = study.plan.table_block}}});
    table.columns.push_back({label(tasks.back().configuration), "median", "ms"});
    table.columns.push_back({label(tasks.back().configuration), "16 ms / ours", "times"});
  }
  const size_t devices = study.session.devices().size();
  if (devices > 1) table.columns.push_back({"", "verdict", "", true});
  SizeSequence sizes(study, study.plan.step_sizes);
  while (sizes.next()) {
    const std::vector<Samples> samples = study.time("step", study.paper_scene(sizes.n()), tasks);
    sizes.measured(samples);
    std::vector<std::string> row = {std::to_string(sizes.n())};
    for (const Samples& one : samples) {
      row.push_back(ms_of(one));
      row.push_back(format_number(16e-3 / one.median_seconds()));
    }
    if (devices > 1) row.push_back(study.compare("step", samples[samples.size() - 2], samples.back()));
    table.rows.push_back(row);
  }
  table.notes = {
      "The paper reports 16 ms for its parallel version up to 16384 spheres: one refresh interval of a 60 Hz display, "
      "an upper bound. The spheres keep moving during the timing."};
  for (const std::string& note : sizes.notes()) table.notes.push_back(note);
  return {table};
}

Table measurement_table(const Study& study, const std::string& name) {
  Table table{
      "Every measurement of " + name,
      {{"", "what", "", true},
       {"", "scene", "", true},
       {"", "n", ""},
       {"", "K", "steps"},
       {"", "rounds", ""},
       {"", "median", "ms"},
       {"95 % interval", "low", "ms"},
       {"95 % interval", "high", "ms"},
       {"", "p95", "ms"},
       {"fixed cost", "of a sample", "us"},
       {"fixed cost", "share", "%"},
       {"", "first", "ms"},
       {"", "device", "ms"},
       {"", "host-device", "ms"}},
      {},
      {"A round takes three batches of K/4, K/2 and K back-to-back steps between two synchronisations of each "
       "contender, in random order, those that are compared in a row; below K = 4 one batch. The line of least "
       "absolute deviations through all batches gives the fixed cost, told with its share of the longest batch. A "
       "round's sample is the median of its batches without that cost, over their steps. first: the kernel's "
       "first use in the run, with its compilation. device: sum of the kernels on the device's timer, from a separate "
       "run; no entry without a reliable timer.",
       "The interval lies between order statistics; with fewer than 6 rounds it covers less than 95 %."}};
  for (const json& row : study.measurements) {
    if (row.at("table") != name) continue;
    const json n = value_of(row, "n");
    table.rows.push_back({row.at("label"), row.contains("scene") ? row.at("scene").at("name").get<std::string>() : "-",
                          n.is_number() ? std::to_string(n.get<uint64_t>()) : "-",
                          std::to_string(row.at("batch").get<uint64_t>()),
                          std::to_string(row.at("rounds").get<uint64_t>()), ms_cell(row.at("median_ms")),
                          ms_cell(row.at("interval_ms")[0]), ms_cell(row.at("interval_ms")[1]),
                          ms_cell(row.at("p95_ms")), number_cell(row.at("fixed_cost_us"), 1),
                          number_cell(row.at("fixed_cost_share"), 100), ms_cell(value_of(row, "first_step_ms")),
                          ms_cell(value_of(row, "device_ms")), ms_cell(value_of(row, "host_minus_device_ms"))});
  }
  return table;
}

}  // namespace spherepair
