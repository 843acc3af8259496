// SPDX-License-Identifier: MIT
// What a backend answers to "which spheres collide", and how two answers are compared.
#pragma once

#include <optional>
#include <stdexcept>

#include "bench/measure/session.h"

namespace spherepair {

// Two backends disagree, or one contradicts itself: exit code 1. `details` is the message in fields, for JSON.
class DifferenceFound : public std::runtime_error {
 public:
  DifferenceFound(const std::string& message, json details)
      : std::runtime_error(message), details(std::move(details)) {}
  json details;
};

// Who is asked: a backend and a method, at a group size where the method has one.
struct Configuration {
  Backend* backend;
  CollideOptions options;
};
bool uses_blocks(const Configuration& configuration);
std::string label(const Configuration& configuration);  // glsl collide_tiled 256
std::string set_name(const CollideOptions& options);    // "all pairs" or "within groups of 64"

// Who the others are compared with for this set.
Configuration reference_for(Session& session, const CollideOptions& options, uint64_t n);

// All that one collision step answers.
struct StepResult {
  Collisions totals;
  std::vector<uint> counts;
  std::optional<std::vector<Pair>> pairs;  // when they were wanted
};
bool same_result(const StepResult& left, const StepResult& right);  // lists only where both have one
StepResult result_of(Backend& backend, bool want_pairs);            // of its last collide()
StepResult run_step(Session& session, Configuration configuration, bool want_pairs);

// Where a comparison stands: for the message.
struct Place {
  const SceneOptions& scene;
  uint64_t step;
};

// Both throw DifferenceFound that names the first difference, and count the comparison in session.comparisons.
// Counts, totals and fingerprints are compared always, pairs when both answers have them; an answer that contradicts
// itself is a difference too.
void require_equal(Session& session, const Place& place, const Configuration& reference, const StepResult& expected,
                   const Configuration& configuration, const StepResult& found);
void require_same_state(Session& session, const Place& place, const Backend& reference, const Backend::State& expected,
                        const Backend& backend, const Backend::State& found);

// Compares the state of every backend with the reference's, which must be finite; returns its hash.
uint64_t require_same_states(Session& session, const Place& place);

}  // namespace spherepair
