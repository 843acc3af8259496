// SPDX-License-Identifier: MIT
// All pairs from small to large n, and whole steps.
#include <fmt/format.h>

#include <algorithm>
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
    row.push_back(time_cell(samples[k]));
    row.push_back(format_rate(per_second));
    if (!on_hardware(*tasks[k].configuration.backend) || std::isnan(rate)) continue;
    row.push_back(format_number(100 * per_second * instructions_per_pair / rate));
  }
  std::ranges::copy(study.compare("scale", samples), std::back_inserter(row));
  return row;
}

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
    if (on_hardware(*task.configuration.backend) && !std::isnan(rate)) table.columns.push_back({group, "floor", "%"});
  }
  add_contest_columns(table, study.session);
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
    table.notes.push_back(
        fmt::format("floor: share of the issue rate, {:.3g} lane-instructions/s (multiprocessors x 128 lanes x highest "
                    "clock), that the pairs take at {} instructions each.",
                    rate, instructions_per_pair));
  table.notes.insert(table.notes.end(), left_out.begin(), left_out.end());
  return {table};
}

std::vector<Table> make_step(Study& study) {
  Table table{"A whole step: motion, plane, all pairs, counts and flags; random scene",
              {{"", "n", ""}, {"", "paper", "ms"}},
              {},
              {"The paper reports 16 ms for its parallel version up to 16384 spheres: one refresh interval of a 60 Hz "
               "display, an upper bound. The spheres keep moving during the timing."}};
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) {
    const bool cpu = backend->info().on_host;
    const Method method = cpu ? Method::parallel : Method::collide_triangle;
    tasks.push_back({Work::step, {backend.get(), {.method = method, .block = study.plan.table_block}}});
    table.columns.push_back({"median", label(tasks.back().configuration), "ms"});
  }
  add_contest_columns(table, study.session);
  SizeSequence sizes(study, study.plan.step_sizes);
  while (sizes.next()) {
    const std::vector<Samples> samples = study.time("step", study.paper_scene(sizes.n()), tasks);
    sizes.measured(samples);
    std::vector<std::string> row = {std::to_string(sizes.n()), sizes.n() <= 16384 ? "16" : "-"};
    for (const Samples& one : samples) row.push_back(time_cell(one));
    std::ranges::copy(study.compare("step", samples), std::back_inserter(row));
    table.rows.push_back(row);
  }
  for (const std::string& note : sizes.notes()) table.notes.push_back(note);
  return {table};
}

}  // namespace spherepair
