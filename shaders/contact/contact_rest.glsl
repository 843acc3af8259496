// SPDX-License-Identifier: MIT
// Which spheres are at rest; see contact_rest.h.
#include "shaders/contact/contact_state.glsl"

#include "common/shared/contact/contact_rest.h"

layout(std430, binding = SLOT_REST) restrict buffer RestBuffer { uint next_event[]; };

bool is_at_rest(uint i) { return sleep_mode(p.motion.whole_state) != SLEEP_NEVER && next_event[i] == REST_SAME; }

// Threads that awaken the same sphere write the same.
void awaken(uint i, uint j) {
  bool first_moved = next_event[i] == REST_MOVED;
  bool second_moved = next_event[j] == REST_MOVED;
  if (first_moved && !second_moved) next_event[j] = REST_AWAKENED;
  if (second_moved && !first_moved) next_event[i] = REST_AWAKENED;
}

void record_rest(uint i, bool same) {
  if (sleep_mode(p.motion.whole_state) != SLEEP_NEVER) next_event[i] = same ? REST_SAME : REST_MOVED;
}
