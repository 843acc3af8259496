// SPDX-License-Identifier: MIT
// The record of what was found equal, and the comparison of two machines' records.
#pragma once

#include <map>

#include "bench/check/step_result.h"

namespace spherepair {

inline constexpr const char* results_format = "spherepair results 1";

struct ComparedStep {
  uint64_t step, pairs, colliding_spheres;
  Fingerprint fingerprint;
  uint64_t state;  // state_hash()
};

// All who answered alike for one set of pairs of one scene, and what they said at each compared step.
struct EqualityEntry {
  SceneOptions scene;
  std::string set;
  std::vector<std::string> answers;
  std::vector<ComparedStep> checkpoints;
};
json to_json(const EqualityEntry& entry);

struct RecordComparison {
  uint64_t compared = 0;
  std::vector<std::string> differences, only_left, only_right;  // configurations
};

// Compares the configurations (scene with all its options, set, step) that two results.json hold both. Throws
// std::invalid_argument that says where one is no record of equality: another format or verdict, fewer comparisons than
// planned, something missing or of the wrong kind, one configuration recorded with two answers.
RecordComparison compare_records(const json& left, const json& right);

// Throws std::invalid_argument for a file that cannot be read or is no results.json.
json read_results(const std::string& path);

}  // namespace spherepair
