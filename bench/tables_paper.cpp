// SPDX-License-Identifier: MIT
// The seed paper's own table and counts, beside ours.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "study.h"

namespace spherepair {
namespace {

// Milliseconds on a GeForce GTX 590 and its host, from the paper's Table 1 and section 6; it prints 0 for what its
// clock could not resolve, and no sequential row for 32,768 spheres.
struct PaperRow {
  uint64_t n;
  const char *fps, *sequential_drawing, *parallel_drawing, *plane, *sequential_pairs, *parallel_pairs;
};
constexpr PaperRow paper_rows[] = {
    {64, "60", "0", "0", "0", "0", "16"},         {128, "60", "1", "0", "0", "0", "16"},
    {256, "61", "2", "0", "0", "0", "16"},        {512, "62", "3", "0", "0.5", "5", "16"},
    {1024, "36", "8", "0", "1", "23", "16"},      {2048, "12", "15", "0", "2", "87", "16"},
    {4096, "4", "32", "0", "3", "340", "16"},     {8192, "4", "60", "0", "7", "1390", "16"},
    {16384, "4", "120", "0", "13", "5560", "16"}, {32768, "-", "-", "-", "-", "-", "47"}};

PaperRow paper_row(uint64_t n) {
  const auto found = std::ranges::find(paper_rows, n, &PaperRow::n);
  return found == std::end(paper_rows) ? PaperRow{n, "-", "-", "-", "-", "-", "-"} : *found;
}

struct Range {
  uint64_t low, high;
  std::string text() const { return low == high ? fmt::format("{}", low) : fmt::format("{}-{}", low, high); }
};
struct PaperCounts {
  uint64_t n;
  std::optional<Range> sequential, parallel;
};
const PaperCounts paper_counts[] = {{64, Range{0, 4}, Range{0, 4}},
                                    {128, Range{7, 15}, Range{6, 20}},
                                    {256, Range{20, 40}, Range{15, 48}},
                                    {512, Range{100, 159}, Range{93, 139}},
                                    {32768, std::nullopt, Range{32000, 32000}}};

const char* place_in(const PaperCounts& paper, uint64_t count) {
  if (paper.n == 32768) return count >= 31000 && count <= 32768 ? "about" : "no";
  const bool in_sequential = paper.sequential && count >= paper.sequential->low && count <= paper.sequential->high;
  const bool in_parallel = paper.parallel && count >= paper.parallel->low && count <= paper.parallel->high;
  return in_sequential && in_parallel ? "both" : in_sequential ? "sequential" : in_parallel ? "parallel" : "no";
}

// The measurements of one size: motion of every backend, then sphere-sphere.
struct Table1Row {
  uint64_t n;
  std::vector<Samples> moves, pairs;
};

std::vector<Task> table1_moves(const Study& study) {
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) tasks.push_back({Work::move, {backend.get(), {}}});
  return tasks;
}

std::vector<Task> table1_pairs(const Study& study) {
  std::vector<Task> tasks;
  for (const auto& backend : study.session.backends()) {
    const bool cpu = backend->info().name == "cpu";
    for (Method method : cpu ? std::vector{Method::sequential, Method::parallel}
                             : std::vector{Method::collide_tiled, Method::collide_triangle})
      if (is_wanted(study.plan, method))
        tasks.push_back({Work::collide, {backend.get(), {.method = method, .block = study.plan.table_block}}});
  }
  return tasks;
}

Table absolute_times(const std::vector<Table1Row>& rows) {
  Table table{"Table 1: times of one step's parts, random scene, medians", {{"", "n", ""}}, {}, {}};
  for (const char* name : {"plane seq", "pairs seq", "pairs par"})
    table.columns.push_back({"paper, GTX 590", name, "ms"});
  for (const Samples& move : rows.front().moves) table.columns.push_back({"ours: motion + plane", move.backend, "ms"});
  for (const Samples& one : rows.front().pairs) {
    const std::string method = one.label.substr(one.backend.size() + 1);
    table.columns.push_back({"ours: pairs, " + one.backend, method.substr(0, method.find(' ')), "ms"});
  }
  for (const Table1Row& row : rows) {
    const PaperRow paper = paper_row(row.n);
    std::vector<std::string> cells = {std::to_string(row.n), paper.plane, paper.sequential_pairs, paper.parallel_pairs};
    for (const Samples& move : row.moves) cells.push_back(format_ms(move.median_seconds()));
    for (const Samples& one : row.pairs) cells.push_back(format_ms(one.median_seconds()));
    table.rows.push_back(cells);
  }
  table.notes = {
      "The paper's 16 ms is one refresh interval of a 60 Hz display: an upper bound, not a measurement. "
      "Its 0 is what its clock could not resolve.",
      "The paper's `pairs par` is its GLSL shader: our collide_tiled is that shader, collide_triangle the fast one. "
      "Ours finds the exact set and each sphere's count, flag and totals."};
  return table;
}

Table speed_ups(const std::vector<Table1Row>& rows) {
  Table table{"Speed-ups, each beside the absolute time of its base", {{"", "n", ""}}, {}, {}};
  const std::vector<Samples>& first = rows.front().pairs;
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
      const double time = row.pairs[base].median_seconds();
      cells.push_back(format_ms(time));
      for (size_t k = 0; k < row.pairs.size(); ++k)
        if (fastest(base, k)) cells.push_back(format_number(time / row.pairs[k].median_seconds()));
    }
    table.rows.push_back(cells);
  }
  table.notes = {
      "glsl and cuda stand for collide_triangle there. Below 1 the column's program is slower than the base."};
  return table;
}

Table paper_table(const std::vector<Table1Row>& rows) {
  Table table{"The paper's Table 1 as printed (GeForce GTX 590)",
              {{"", "n", ""},
               {"", "fps", "1/s"},
               {"drawing", "sequential", "ms"},
               {"drawing", "parallel", "ms"},
               {"sphere-plane", "sequential", "ms"},
               {"sphere-sphere", "sequential", "ms"},
               {"sphere-sphere", "parallel", "ms"}},
              {},
              {"Drawing is not measured here. 32768: from the paper's text."}};
  for (const Table1Row& row : rows) {
    const PaperRow p = paper_row(row.n);
    table.rows.push_back({std::to_string(row.n), p.fps, p.sequential_drawing, p.parallel_drawing, p.plane,
                          p.sequential_pairs, p.parallel_pairs});
  }
  return table;
}

// Colliding spheres over the animation, counted by the fastest backend after all have agreed on frame 0.
std::vector<std::string> count_row(Study& study, const SceneOptions& scene, const PaperCounts* paper) {
  const uint64_t steps = scene.n > 16384 ? study.plan.count_steps_large : study.plan.count_steps;
  std::vector<Asked> asked;
  for (const auto& backend : study.session.backends())
    asked.push_back(
        {backend.get(), {.method = backend->info().name == "cpu" ? Method::parallel : Method::collide_triangle}});
  const uint64_t first = study.check(scene, asked).totals.colliding_spheres;
  Range range{first, first};
  const auto hardware = std::ranges::find_if(asked, [](const Asked& a) { return on_hardware(*a.backend); });
  const Asked counter = hardware == asked.end() ? asked.front() : *hardware;
  for (uint64_t step = 1; step <= steps; ++step) {
    study.progress.say(fmt::format("counts: {} n = {}, step {} of {}", scene_label(scene), scene.n, step, steps));
    counter.backend->move();
    study.session.collide(*counter.backend, counter.options);
    const uint64_t count = counter.backend->collisions().colliding_spheres;
    range = {std::min(range.low, count), std::max(range.high, count)};
  }
  const bool known = paper != nullptr;
  return {scene_label(scene),
          std::to_string(scene.n),
          std::to_string(first),
          fmt::format("{}-{}", range.low, range.high),
          std::to_string(steps),
          known && paper->sequential ? paper->sequential->text() : "-",
          known && paper->parallel ? (scene.n == 32768 ? "32000" : paper->parallel->text()) : "-",
          known ? place_in(*paper, first) : "-"};
}

}  // namespace

std::vector<Table> make_table1(Study& study) {
  std::vector<Table1Row> rows;
  const std::vector<Task> moves = table1_moves(study), pairs = table1_pairs(study);
  for (uint64_t n : study.plan.paper_sizes) {
    const SceneOptions scene = study.paper_scene(n);
    rows.push_back({n, study.time("table1", scene, moves), study.time("table1", scene, pairs)});
  }
  return {absolute_times(rows), speed_ups(rows), paper_table(rows)};
}

std::vector<Table> make_counts(Study& study) {
  Table table{
      "Colliding spheres: ours beside the paper's",
      {{"", "scene", "", true},
       {"", "n", ""},
       {"ours", "frame 0", "spheres"},
       {"ours", "min-max", "spheres"},
       {"ours", "over", "steps"},
       {"the paper's range", "sequential", "spheres"},
       {"the paper's range", "parallel", "spheres"},
       {"", "frame 0 in range", "", true}},
      {},
      {"A step is 1/64 s. The paper does not say over which time its ranges were taken; it says \"32,000\" for 32768. "
       "For its aligned animation it gives arrangements but no counts."}};
  for (const PaperCounts& paper : paper_counts)
    if (std::ranges::find(study.plan.count_sizes, paper.n) != study.plan.count_sizes.end())
      table.rows.push_back(count_row(study, study.paper_scene(paper.n), &paper));
  for (const char* shape : {"8x16", "16x8", "8x32", "16x16", "32x8", "8x64", "16x32", "64x8"}) {
    SceneOptions scene = study.paper_scene(0);
    std::sscanf(shape, "%ux%u", &scene.groups, &scene.group_size);
    scene.name = "aligned";
    scene.n = uint64_t(scene.groups) * scene.group_size;
    table.rows.push_back(count_row(study, scene, nullptr));
  }
  return {table};
}

}  // namespace spherepair
