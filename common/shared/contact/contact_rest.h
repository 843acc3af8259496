// SPDX-License-Identifier: MIT
// Drag by a fluid at rest, with which spheres come to rest to the bit, and spheres at rest, which a step passes over
// (sleeping): the impulses on a sphere depend on its own state and on those of its near spheres alone, so where none of
// these changed in the last step, the sphere's does not change in this one.
#ifndef SPHEREPAIR_CONTACT_REST_H
#define SPHEREPAIR_CONTACT_REST_H

#include "common/shared/contact/contact.h"
#include "common/shared/contact/skin.h"

// Of SLOT_REST: what the last step did to each sphere. Awake are those that are not at rest: all, where near pairs have
// just been listed, since a sphere that flew off may have left the list.
#define REST_MOVED 0u     // changed its state
#define REST_SAME 1u      // did not, and no near sphere's: at rest
#define REST_AWAKENED 2u  // did not, but a near sphere's

// ContactParams::sleeping: one of SLEEP_MODES, and TESTS_ALL_WALLS of leapfrog.
#define SLEEP_MODES 3u
#define SLEEP_NEVER 0u    // SLOT_REST is not used
#define SLEEP_AT_REST 1u  // spheres at rest are passed over
#define SLEEP_AWAKENS 2u  // of contact_pairs, ahead of the above: awakens what is near a sphere that moved
#define TESTS_ALL_WALLS 4u
FN uint sleep_mode(ContactParams c) { return c.sleeping & SLEEP_MODES; }

// By the drag of half a step. The factor is the loss and not what is left: float32 keeps 24 bits of a small loss, but
// few of the difference between 1 and a factor near 1.
FN Body slowed(Body s, ContactParams c) {
  if (c.drag_loss == 0.0f) return s;
  s.px -= scaled(s.px, c.drag_loss);
  s.py -= scaled(s.py, c.drag_loss);
  s.pz -= scaled(s.pz, c.drag_loss);
  return s;
}

// Momentum before position, by half of the drag, the impulses, and the other half.
FN Body kicked_in_fluid(Body s, Push contacts, Push walls, ContactParams c) {
  return slowed(kicked(slowed(s, c), contacts, walls, c), c);
}

FN bool is_same(Body a, Body b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.px == b.px && a.py == b.py && a.pz == b.pz;
}

#endif
