// SPDX-License-Identifier: MIT
// The seed paper's Table 1, sphere-plane and sphere-sphere, and our times.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bench/tables/paper_rows.h"
#include "bench/tables/study.h"

namespace spherepair {
namespace {

// The measurements of one size: motion of every backend, then sphere-sphere.
struct Table1Row {
  uint64_t n;
  std::vector<Samples> moves;
  std::vector<std::optional<Samples>> pairs;  // by task; none if it would have taken too long
};

bool complete(const Table1Row& row) {
  return std::ranges::all_of(row.pairs, [](const auto& one) { return one.has_value(); });
}

std::string ms_cell(const std::optional<Samples>& samples) { return samples ? ms_of(*samples) : "left out"; }

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

Table absolute_times(const std::vector<Table1Row>& rows) {
  Table table{"Table 1: times of the parts of a step, random scene, medians", {{"", "n", ""}}, {}, {}};
  for (const char* name : {"plane seq", "pairs seq", "pairs par"})
    table.columns.push_back({"paper, GTX 590", name, "ms"});
  for (const Samples& move : rows.front().moves) table.columns.push_back({"ours: motion + plane", move.backend, "ms"});
  for (const auto& one : rows.front().pairs) {
    const std::string method = one->label.substr(one->backend.size() + 1);
    table.columns.push_back({"ours: pairs, " + one->backend, method.substr(0, method.find(' ')), "ms"});
  }
  for (const Table1Row& row : rows) {
    const PaperRow paper = paper_row(row.n);
    std::vector<std::string> cells = {std::to_string(row.n), paper.plane, paper.sequential_pairs, paper.parallel_pairs};
    for (const Samples& move : row.moves) cells.push_back(ms_of(move));
    for (const auto& one : row.pairs) cells.push_back(ms_cell(one));
    table.rows.push_back(cells);
  }
  table.notes = {
      "The paper's 16 ms is one refresh interval of a 60 Hz display: an upper bound, not a measurement. "
      "Its 0 is below the resolution of its clock.",
      "The paper's `pairs par` is its GLSL shader: our collide_tiled is that shader, collide_triangle the fastest one. "
      "Ours find the exact set, the count and flag of each sphere, and totals.",
      "left out: it would take too long without a GPU; --full or --n includes it."};
  if (std::ranges::all_of(rows, complete)) table.notes.pop_back();
  return table;
}

std::string speedup(const std::optional<Samples>& base, const std::optional<Samples>& other) {
  if (!base || !other) return "-";
  return marked(marked(format_number(base->median_seconds() / other->median_seconds()), *base), *other);
}

Table speedups(const std::vector<Table1Row>& rows) {
  Table table{"Speedups, and the absolute time of each base", {{"", "n", ""}}, {}, {}};
  std::vector<Samples> first;
  for (const auto& one : rows.front().pairs) first.push_back(*one);
  std::vector<size_t> bases;
  for (size_t k = 0; k < first.size(); ++k)
    if (first[k].label.find("sequential") != std::string::npos ||
        first[k].label.find("parallel") != std::string::npos ||
        first[k].label.find("collide_tiled") != std::string::npos)
      bases.push_back(k);
  const auto fastest = [&](size_t base, size_t k) {
    return k != base && (first[k].label.find("collide_triangle") != std::string::npos ||
                         (first[base].label.find("sequential") != std::string::npos &&
                          first[k].label.find("parallel") != std::string::npos));
  };
  for (size_t base : bases) {
    const std::string group = "over " + first[base].label;
    table.columns.push_back({group, "base", "ms"});
    for (size_t k = 0; k < first.size(); ++k)
      if (fastest(base, k))
        table.columns.push_back({group, first[k].label.substr(0, first[k].label.find(" collide")), "times"});
  }
  for (const Table1Row& row : rows) {
    std::vector<std::string> cells = {std::to_string(row.n)};
    for (size_t base : bases) {
      cells.push_back(ms_cell(row.pairs[base]));
      for (size_t k = 0; k < row.pairs.size(); ++k)
        if (fastest(base, k)) cells.push_back(speedup(row.pairs[base], row.pairs[k]));
    }
    table.rows.push_back(cells);
  }
  table.notes = {"glsl and cuda: collide_triangle. Below 1: slower than the base."};
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
  return {absolute_times(rows), speedups(rows)};
}

}  // namespace spherepair
