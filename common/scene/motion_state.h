// SPDX-License-Identifier: MIT
// What a method remembers of n spheres besides float32 positions and velocities, laid out as in the buffers SLOT_WIDE
// to SLOT_NEXT_EVENT. The words are the same on every backend, so one can go on where another stopped.
#pragma once

#include <cstring>

#include "common/scene/scene.h"
#include "common/shared/two.h"

namespace spherepair {

struct MotionState {
  uint steps = 0;                       // made so far, of `anchored`
  uint64_t contact_steps = 0;           // made with contacts; only for messages
  std::vector<uint> wide;               // Real[6n]; empty for float32
  std::vector<vec4> anchors;            // this and the next three: only for `anchored`
  std::vector<uint> flights;            // Real[2n]
  std::vector<uint> since, next_event;  // n each
};

// Calls visit for each buffer with its slot, its name in messages and files, and its vector.
template <typename State, typename Visit>
void visit_parts(State& state, Visit visit) {
  visit(SLOT_WIDE, "wide state", state.wide);
  visit(SLOT_ANCHOR, "anchors", state.anchors);
  visit(SLOT_FLIGHT, "flights", state.flights);
  visit(SLOT_SINCE, "steps of the anchors", state.since);
  visit(SLOT_NEXT_EVENT, "due steps", state.next_event);
}

// Returns the number of 32-bit words in a number.
inline uint real_words(Precision precision) { return precision == Precision::float32 ? 1 : 2; }

// Returns the state at the start, from the scene's positions and velocities; params are the scene's.
MotionState initial_state(const Scene& scene, const MotionParams& params);

template <typename Real>
Real load_real(const std::vector<uint>& words, uint64_t i) {
  Real value;
  std::memcpy(&value, &words[i * (sizeof(Real) / sizeof(uint))], sizeof(Real));
  return value;
}
template <typename Real>
void store_real(std::vector<uint>& words, uint64_t i, Real value) {
  std::memcpy(&words[i * (sizeof(Real) / sizeof(uint))], &value, sizeof(Real));
}

// Calls work(Real{}), where Real is the number type of this precision.
template <typename Work>
auto with_real(Precision precision, Work work) {
  if (precision == Precision::compensated) return work(Two{});
  if (precision == Precision::float64) return work(double{});
  return work(float{});
}

// Returns the n velocities of the wide state, rounded to float32.
std::vector<vec4> rounded_velocities(const std::vector<uint>& wide, Precision precision, uint64_t n);

}  // namespace spherepair
