// SPDX-License-Identifier: MIT
// What was compared, in rows that a reader can take in: methods with their group sizes and backends.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "study.h"

namespace spherepair {
namespace {

// All answers to one set of one scene, gathered over the lockstep and the checks before each timing.
struct Gathered {
  SceneOptions scene;
  std::string set;
  uint64_t comparisons = 0;
  Checkpoint last{};
  std::map<std::string, std::pair<std::set<uint>, std::set<std::string>>> methods;  // group sizes and backends
};

void add_answers(Gathered& row, const std::vector<std::string>& answers) {
  for (const std::string& answer : answers) {
    std::istringstream words(answer);
    std::string backend, method;
    uint block = 0;
    words >> backend >> method;
    auto& [blocks, backends] = row.methods[method];
    if (words >> block) blocks.insert(block);
    backends.insert(backend);
  }
}

std::map<std::string, Gathered> gather(const std::vector<EqualityEntry>& entries) {
  std::map<std::string, Gathered> rows;
  for (const EqualityEntry& entry : entries) {
    if (entry.answers.size() < 2) continue;
    Gathered& row = rows[scene_json(entry.scene).dump() + entry.set];
    row.scene = entry.scene;
    row.set = entry.set;
    row.comparisons += entry.checkpoints.size() * (entry.answers.size() - 1);
    if (entry.checkpoints.back().step >= row.last.step) row.last = entry.checkpoints.back();
    add_answers(row, entry.answers);
  }
  return rows;
}

std::string blocks_text(const std::set<uint>& blocks) {
  if (blocks.empty()) return "-";
  if (blocks.size() < 3) return fmt::format("{}", fmt::join(blocks, ", "));
  return fmt::format("{}..{} ({})", *blocks.begin(), *blocks.rbegin(), blocks.size());
}

const char* reference_text(const Session& session) {
  return session.find("cpu") ? "the CPU" : "the first open backend, for the CPU was left out";
}

}  // namespace

std::vector<Table> make_equality(Study& study) {
  Table table{"What was compared and found equal: states bit by bit, collision sets pair by pair",
              {{"", "scene", "", true},
               {"", "n", ""},
               {"", "seed", ""},
               {"", "steps", ""},
               {"", "method", "", true},
               {"", "group sizes", "", true},
               {"", "backends", "", true},
               {"", "pairs", "last step"},
               {"", "fingerprint", "last step", true},
               {"", "verdict", "", true}},
              {},
              {}};
  uint64_t comparisons = 0;
  for (const auto& [key, row] : gather(study.equality)) {
    comparisons += row.comparisons;
    for (const auto& [method, who] : row.methods) {
      table.rows.push_back({scene_label(row.scene), std::to_string(row.scene.n), std::to_string(row.scene.seed),
                            std::to_string(row.last.step), method, blocks_text(who.first),
                            fmt::format("{}", fmt::join(who.second, " ")), std::to_string(row.last.pairs),
                            hex64(row.last.fingerprint.a) + hex64(row.last.fingerprint.b), "equal"});
    }
  }
  table.notes = {
      fmt::format(
          "{} answers were compared with a reference, all equal: number of pairs and of colliding spheres, each "
          "sphere's count, fingerprint, and up to 10^6 pairs the whole list. The reference is {}.",
          comparisons, reference_text(study.session)),
      "Rows of one scene, n and set share one fingerprint: they are the same set of pairs."};
  return {table};
}

}  // namespace spherepair
