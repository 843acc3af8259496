// SPDX-License-Identifier: MIT
// Records results that were found equal, and compares the records of two machines.
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

// The configurations that found the same set of pairs of one scene, and that set at each compared step.
struct EqualityEntry {
  SceneOptions scene;
  std::string set;
  std::vector<std::string> configurations;  // labels
  std::vector<ComparedStep> checkpoints;
  ContactOptions contact = {};
  float dt = 0, restitution = 0;  // with contacts
};
json to_json(const EqualityEntry& entry);

struct RecordComparison {
  uint64_t compared = 0;
  std::vector<std::string> differences, only_left, only_right;  // scene, set and step
};

// Compares every (scene with all its options, set, step) that both results.json contain. Throws std::invalid_argument
// with the position if one is not a record of equality: another format or verdict, fewer comparisons than planned, a
// missing or malformed value, two different results for the same configuration.
RecordComparison compare_records(const json& left, const json& right);

// Throws std::invalid_argument for a file that cannot be read or is not a results.json.
json read_results(const std::string& path);

}  // namespace spherepair
