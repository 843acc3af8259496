// SPDX-License-Identifier: MIT
// The original paper's Table 1, sphere-plane and sphere-sphere, and our times.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "bench/tables/paper_rows.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

// The measurements of one size: motion of every backend, then sphere-sphere.
struct Table1Row {
  uint64_t n;
  std::vector<Samples> moves;
  std::vector<std::optional<Samples>> pairs;  // by task; none if the task would have taken too long
};

bool complete(const Table1Row& row) {
  return std::ranges::all_of(row.pairs, [](const auto& one) { return one.has_value(); });
}

std::vector<Task> table1_moves(const Study& study) {
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) tasks.push_back({Work::move, {backend.get(), {}}});
  return tasks;
}

std::vector<Task> table1_pairs(const Study& study) {
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) {
    const bool cpu = backend->info().on_host;
    for (Method method : cpu ? std::vector{Method::sequential, Method::parallel}
                             : std::vector{Method::collide_tiled, Method::collide_triangle})
      if (is_wanted(study.plan, method))
        tasks.push_back({Work::collide, {backend.get(), {.method = method, .block = study.plan.table_block}}});
  }
  return tasks;
}

// Without a GPU, drops tasks that would take too long at this size, extrapolated from the last row.
std::vector<Task> leave_out_slow(const Study& study, const std::vector<Task>& tasks, const std::vector<Table1Row>& rows,
                                 uint64_t n) {
  if (study.plan.hardware || rows.empty()) return tasks;
  const double ratio = double(n) / double(rows.back().n);
  std::vector<Task> affordable;
  for (size_t k = 0; k < tasks.size(); ++k) {
    const auto& last = rows.back().pairs[k];
    if (!last) continue;
    const double seconds = predict_seconds({&*last, 1}, std::max(1.0, ratio * ratio), study.plan.sampling);
    if (seconds <= study.plan.row_seconds / 2) affordable.push_back(tasks[k]);
  }
  return affordable;
}

// The time of each backend; none if it was left out.
using Found = std::map<std::string, std::optional<Samples>>;

std::vector<std::string> cells_of(const Study& study, uint64_t n, const std::string& part, const std::string& paper,
                                  const Found& found) {
  std::vector<std::string> cells = {std::to_string(n), part, paper};
  for (const auto& backend : study.session.backends()) {
    const auto one = found.find(backend->info().name);
    cells.push_back(one == found.end() ? "-" : one->second ? time_cell(*one->second) : "left out");
  }
  for (const auto& [device, baseline] : study.session.contests()) {
    const auto left = found.find(device->info().name), right = found.find(baseline->info().name);
    const bool both = left != found.end() && right != found.end() && left->second && right->second;
    cells.push_back(both ? ratio_text(contest(*left->second, *right->second)) : "-");
  }
  return cells;
}

Found pairs_of(const std::vector<Task>& tasks, const Table1Row& row, Method method) {
  Found found;
  for (size_t k = 0; k < tasks.size(); ++k)
    if (tasks[k].configuration.options.method == method)
      found[tasks[k].configuration.backend->info().name] = row.pairs[k];
  return found;
}

// A row for each size and part of a step.
Table absolute_times(const Study& study, const std::vector<Task>& tasks, const std::vector<Table1Row>& rows) {
  Table table{"Table 1: times of the parts of a step, random scene",
              {{"", "n", ""}, {"", "part", "", true}, {"", "paper", "ms"}},
              {},
              {}};
  for (const auto& backend : study.session.backends()) table.columns.push_back({"median", backend->info().name, "ms"});
  add_contest_columns(table, study.session);
  for (const Table1Row& row : rows) {
    const PaperRow paper = paper_row(row.n);
    Found moves;
    for (const Samples& move : row.moves) moves[move.backend] = move;
    table.rows.push_back(cells_of(study, row.n, "motion + plane", paper.plane, moves));
    for (const auto& [method, of_paper] : {std::pair{Method::sequential, paper.sequential_pairs},
                                           {Method::parallel, "-"},
                                           {Method::collide_tiled, paper.parallel_pairs},
                                           {Method::collide_triangle, "-"}})
      if (const Found pairs = pairs_of(tasks, row, method); !pairs.empty())
        table.rows.push_back(cells_of(study, row.n, method_name(method), of_paper, pairs));
  }
  table.notes = {
      "The paper's times are of a GTX 590 and its host. Its 16 ms is one refresh interval of a 60 Hz display: an upper "
      "bound, not a measurement. Its 0 is below the resolution of its clock.",
      "sequential, parallel and collide_ find the pairs: the exact set, the count and flag of each sphere, and totals. "
      "collide_tiled is the paper's shader, collide_triangle the fastest.",
      "left out: it would take too long without a GPU; --full or --n includes it."};
  if (std::ranges::all_of(rows, complete)) table.notes.pop_back();
  return table;
}

}  // namespace

std::vector<Table> make_table1(Study& study) {
  std::vector<Table1Row> rows;
  const std::vector<Task> moves = table1_moves(study), pairs = table1_pairs(study);
  for (uint64_t n : study.plan.paper_sizes) {
    const std::vector<Task> affordable = leave_out_slow(study, pairs, rows, n);
    const SceneOptions scene = study.paper_scene(n);
    Table1Row row{n, study.time("table1", scene, moves), std::vector<std::optional<Samples>>(pairs.size())};
    const std::vector<Samples> samples = study.time("table1", scene, affordable);
    for (size_t k = 0; k < pairs.size(); ++k)
      for (const Samples& one : samples)
        if (one.label == label(pairs[k])) row.pairs[k] = one;
    rows.push_back(std::move(row));
  }
  return {absolute_times(study, pairs, rows)};
}

}  // namespace spherepair
