// SPDX-License-Identifier: MIT
// Drag by a fluid at rest, and sleeping: steps skip spheres that have come to rest to the bit. The impulses on a sphere
// depend only on its own state and on its near spheres' states. If none of these changed in the last step, the sphere
// does not change in this one.
#ifndef SPHEREPAIR_CONTACT_REST_H
#define SPHEREPAIR_CONTACT_REST_H

#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"

// Values of SLOT_REST: what the last step did to each sphere. Spheres not at rest are awake. All are awake when near
// pairs have just been listed, since a sphere that flew off may have left the list.
#define REST_MOVED 0u     // changed its state
#define REST_SAME 1u      // changed nothing, nor did its near spheres: at rest
#define REST_AWAKENED 2u  // changed nothing, but a near sphere did

// ContactParams::sleeping is one of SLEEP_MODES, plus TESTS_ALL_WALLS for leapfrog.
#define SLEEP_MODES 3u
#define SLEEP_NEVER 0u    // SLOT_REST is not used
#define SLEEP_AT_REST 1u  // steps skip spheres at rest
#define SLEEP_AWAKENS 2u  // contact_pairs, launched before that: awakens spheres near one that moved
#define TESTS_ALL_WALLS 4u
FN uint sleep_mode(ContactParams c) { return c.sleeping & SLEEP_MODES; }

// Applies the drag of half a step. The factor is the loss, not the remainder: float32 keeps 24 bits of a small loss,
// but few of the difference between 1 and a factor near 1.
FN Body slowed(Body s, ContactParams c) {
  if (c.drag_loss == 0.0f) return s;
  s.px -= scaled(s.px, c.drag_loss);
  s.py -= scaled(s.py, c.drag_loss);
  s.pz -= scaled(s.pz, c.drag_loss);
  return s;
}

// Returns the sphere after half of the drag, the impulses, and the other half; its position has not moved yet.
FN Body kicked_in_fluid(Body s, Push contacts, Push walls, ContactParams c) {
  return slowed(kicked(slowed(s, c), contacts, walls, c), c);
}

FN bool is_same(Body a, Body b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.px == b.px && a.py == b.py && a.pz == b.pz;
}

#endif
