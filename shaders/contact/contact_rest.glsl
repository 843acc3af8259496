// SPDX-License-Identifier: MIT
// Reads and updates which spheres are at rest; see contact_rest.h.
#include "shaders/contact/contact_state.glsl"

#include "common/shared/contact/contact_rest.h"

layout(std430, binding = SLOT_REST) restrict buffer RestBuffer { uint rest[]; };

bool is_at_rest(uint i) { return sleep_mode(p.contact) != SLEEP_NEVER && rest[i] == REST_SAME; }

// Awakens a sphere near one that moved. Threads that awaken the same sphere write the same value.
void awaken(uint i, uint j) {
  bool first_moved = rest[i] == REST_MOVED;
  bool second_moved = rest[j] == REST_MOVED;
  if (first_moved && !second_moved) rest[j] = REST_AWAKENED;
  if (second_moved && !first_moved) rest[i] = REST_AWAKENED;
}

void record_rest(uint i, bool same) {
  if (sleep_mode(p.contact) != SLEEP_NEVER) rest[i] = same ? REST_SAME : REST_MOVED;
}
