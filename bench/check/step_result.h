// SPDX-License-Identifier: MIT
// The result of a collision step, and the comparison of two results.
#pragma once

#include <optional>
#include <stdexcept>

#include "bench/measure/session.h"

namespace spherepair {

// The results of two backends differ, or one is inconsistent: exit code 1. `details`: the message as JSON fields.
class DifferenceFound : public std::runtime_error {
 public:
  DifferenceFound(const std::string& message, json details)
      : std::runtime_error(message), details(std::move(details)) {}
  json details;
};

// A backend and the options of its collision step.
struct Configuration {
  Backend* backend;
  CollideOptions options;
};
bool uses_blocks(const Configuration& configuration);
// Returns the requested group size; throws std::invalid_argument if it would have no effect.
uint require_groups(const Configuration& configuration, uint block);
std::string label(const Configuration& configuration);  // opengl collide_tiled 256
std::string set_name(const CollideOptions& options);    // "all pairs" or "within groups of 64"

// The configuration that the others are compared with for this set.
Configuration reference_for(Session& session, const CollideOptions& options, uint64_t n);

// Everything that a collision step returns.
struct StepResult {
  Collisions totals;
  std::vector<uint> counts;
  std::optional<std::vector<Pair>> pairs;  // if they were requested
};
std::string hex(const Fingerprint& fingerprint);
bool same_result(const StepResult& left, const StepResult& right);  // compares lists only if both have one
StepResult result_of(Search& search, bool want_pairs);              // of its last collide()
StepResult run_step(Session& session, Configuration configuration, bool want_pairs);

// The scene and step of a comparison, for messages.
struct ComparisonPoint {
  const SceneOptions& scene;
  uint64_t step;
};

// Both throw DifferenceFound naming the first difference, and count the comparison in session.comparisons. Counts,
// totals and fingerprints are always compared, lists if both results have one. An inconsistent result is a difference,
// too.
void require_equal(Session& session, const ComparisonPoint& point, const Configuration& reference,
                   const StepResult& expected, const Configuration& configuration, const StepResult& found);
void require_same_state(Session& session, const ComparisonPoint& point, const Backend& reference,
                        const Motion::State& expected, const Backend& backend, const Motion::State& found);

// Compares the state of every backend with the reference's, which must be finite; returns its hash.
uint64_t require_same_states(Session& session, const ComparisonPoint& point);
void compare_states(Session& session, const ComparisonPoint& point);  // the same, also planned as comparisons

}  // namespace spherepair
