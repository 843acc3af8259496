// SPDX-License-Identifier: MIT
#include "equality.h"

#include <fmt/format.h>

#include "file_bytes.h"

namespace spherepair {
namespace {

std::string hex(const Fingerprint& fingerprint) { return hex64(fingerprint.a) + hex64(fingerprint.b); }

// Everything that decides a set, and nothing that does not.
std::string key_of(const json& entry, const json& checkpoint) {
  return fmt::format("{} | {} | step {}", json_line(entry.at("scene")), entry.at("set").get<std::string>(),
                     checkpoint.at("step").get<uint64_t>());
}

// One configuration may be recorded several times within a run: by the lockstep and before each timing.
std::map<std::string, std::string> records(const json& results) {
  std::map<std::string, std::string> found;
  for (const json& entry : results.at("equality")) {
    for (const json& point : entry.at("checkpoints")) {
      found[key_of(entry, point)] =
          fmt::format("{} pairs, {} colliding spheres, fingerprint {}, state {}", point.at("pairs").get<uint64_t>(),
                      point.at("colliding_spheres").get<uint64_t>(), point.at("fingerprint").get<std::string>(),
                      point.at("state").get<std::string>());
    }
  }
  return found;
}

}  // namespace

json to_json(const EqualityEntry& entry) {
  json points = json::array();
  for (const Checkpoint& point : entry.checkpoints)
    points.push_back({{"step", point.step},
                      {"pairs", point.pairs},
                      {"colliding_spheres", point.colliding_spheres},
                      {"fingerprint", hex(point.fingerprint)},
                      {"state", hex64(point.state)}});
  return {{"scene", scene_json(entry.scene)},
          {"set", entry.set},
          {"answers", entry.answers},
          {"verdict", "equal"},
          {"checkpoints", points}};
}

RecordComparison compare_records(const json& left, const json& right) {
  const auto ours = records(left), theirs = records(right);
  RecordComparison result;
  for (const auto& [key, value] : ours) {
    const auto other = theirs.find(key);
    if (other == theirs.end()) {
      ++result.only_left;
      continue;
    }
    ++result.compared;
    if (other->second != value)
      result.differences.push_back(fmt::format("{}:\n    {}\n    {}", key, value, other->second));
  }
  result.only_right = theirs.size() - result.compared;
  return result;
}

json read_results(const std::string& path) {
  const FileBytes file(path);
  json results;
  try {
    results = json::parse(file.bytes());
    records(results);
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("{} is not the results.json of a compare run: {}", path, error.what()));
  }
  return results;
}

}  // namespace spherepair
