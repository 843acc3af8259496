// SPDX-License-Identifier: MIT
// The table of results that were compared and found equal: methods with their group sizes and backends.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

#include "bench/io/scene_text.h"
#include "bench/tables/study.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

// All comparisons of one set of one scene, from the lockstep check and the checks before each timing.
struct Gathered {
  SceneOptions scene;
  std::string set;
  uint64_t comparisons = 0;
  ComparedStep last{};
  std::map<std::string, std::pair<std::set<uint>, std::set<std::string>>> methods;  // group sizes and backends
};

void add_configurations(Gathered& row, const std::vector<std::string>& labels) {
  for (const std::string& label : labels) {
    std::istringstream words(label);
    std::string backend, method;
    uint block = 0;
    words >> backend >> method;
    auto& [blocks, backends] = row.methods[method];
    if (words >> block) blocks.insert(block);
    backends.insert(backend);
  }
}

// Ordered by scene and size, all pairs before groups, small groups before large.
using Key = std::tuple<std::string, uint64_t, std::string, size_t, std::string>;

std::map<Key, Gathered> gather(const std::vector<EqualityEntry>& entries) {
  std::map<Key, Gathered> rows;
  for (const EqualityEntry& entry : entries) {
    if (entry.configurations.size() < 2) continue;
    const SceneOptions& scene = entry.scene;
    Gathered& row = rows[{scene_label(scene), scene.n, json_line(scene_json(scene)), entry.set.size(), entry.set}];
    row.scene = scene;
    row.set = entry.set;
    row.comparisons += entry.checkpoints.size() * (entry.configurations.size() - 1);
    if (entry.checkpoints.back().step >= row.last.step) row.last = entry.checkpoints.back();
    add_configurations(row, entry.configurations);
  }
  return rows;
}

std::string blocks_text(const std::set<uint>& blocks) {
  if (blocks.empty()) return "-";
  if (blocks.size() < 3) return fmt::format("{}", fmt::join(blocks, ", "));
  return fmt::format("{}..{} ({})", *blocks.begin(), *blocks.rbegin(), blocks.size());
}

const char* reference_text(const Session& session) {
  return session.find("cpu") ? "the CPU" : "the first open backend, since the CPU is not among them";
}

Table every_method(const std::map<Key, Gathered>& rows) {
  Table table{"Every method and group size found equal",
              {{"", "scene", "", true},
               {"", "n", ""},
               {"", "seed", ""},
               {"", "steps", ""},
               {"", "set", "", true},
               {"", "method", "", true},
               {"", "group sizes", "", true},
               {"", "backends", "", true},
               {"", "pairs", "last step"},
               {"", "fingerprint", "last step", true},
               {"", "verdict", "", true}},
              {},
              {"Rows of the same scene, n and set have the same fingerprint: it is the same set of pairs."},
              true};
  for (const auto& [key, row] : rows)
    for (const auto& [method, found] : row.methods)
      table.rows.push_back({scene_label(row.scene), std::to_string(row.scene.n), std::to_string(row.scene.seed),
                            std::to_string(row.last.step), row.set, method, blocks_text(found.first),
                            fmt::format("{}", fmt::join(found.second, " ")), std::to_string(row.last.pairs),
                            hex(row.last.fingerprint), "equal"});
  return table;
}

// Per scene and size: the number of comparisons, and the set of all pairs after the last step.
Table summary(const std::map<Key, Gathered>& rows, const Session& session) {
  Table table{"Compared and found equal: states bit by bit, collision sets pair by pair",
              {{"", "scene", "", true},
               {"", "n", ""},
               {"", "steps", ""},
               {"", "compared", "results"},
               {"all pairs after the last step", "pairs", ""},
               {"all pairs after the last step", "fingerprint", "first half", true}},
              {},
              {}};
  uint64_t total = 0, last_n = UINT64_MAX;
  std::string last_scene;
  for (const auto& [key, row] : rows) {
    total += row.comparisons;
    const std::string scene = std::get<2>(key);
    if (scene != last_scene || row.scene.n != last_n) {
      const bool all = row.set == "all pairs";
      table.rows.push_back({scene_label(row.scene), std::to_string(row.scene.n), std::to_string(row.last.step), "0",
                            all ? std::to_string(row.last.pairs) : "-", all ? hex64(row.last.fingerprint.a) : "-"});
    }
    std::string& count = table.rows.back()[3];
    count = std::to_string(std::stoull(count) + row.comparisons);
    last_scene = scene;
    last_n = row.scene.n;
  }
  table.notes = {fmt::format(
      "{} compared with a reference, all equal: number of pairs and of colliding spheres, the count of "
      "each sphere, the fingerprint, and in the lockstep check, up to 10^6 pairs, the list of pairs. The reference is "
      "{}. Every method and group size, and whole fingerprints: equality.csv.",
      counted(total, "result"), reference_text(session))};
  return table;
}

}  // namespace

std::vector<Table> make_equality(Study& study) {
  const std::map<Key, Gathered> rows = gather(study.equality);
  return {summary(rows, study.session), every_method(rows)};
}

}  // namespace spherepair
