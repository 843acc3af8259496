// SPDX-License-Identifier: MIT
// When near pairs have to be listed again. A list of near pairs (a Verlet list) serves contacts for many steps. The
// search lists pairs of float32 centres with radii grown by a skin. The list serves while no centre has moved farther
// than its own skin, less the rounding of both centres: then the grown spheres of any pair in contact had collided.
#ifndef SPHEREPAIR_SKIN_H
#define SPHEREPAIR_SKIN_H

#include "common/shared/contact/periodic.h"

// Words of SLOT_FAULT after the faults. Steps are launched ahead. Once a sphere has left its skin, later steps do
// nothing: contact_pairs, during which LEFT_SKIN does not change, sets STOPPED for leapfrog. Otherwise it counts the
// step as done.
#define LEFT_SKIN FAULTS          // a sphere that has left its skin, or ~0
#define STOPPED (FAULTS + 1u)     // not 0: this step does nothing
#define STEPS_DONE (FAULTS + 2u)  // since near pairs were listed
#define FAULT_WORDS (FAULTS + 3u)

FN vec4 grown_sphere(vec4 sphere, ContactParams c) {
  EXACT float thickness = sphere.w * c.skin;
  EXACT float radius = sphere.w + thickness;
  vec4 grown = {sphere.x, sphere.y, sphere.z, radius};
  return grown;
}
// Returns how far rounding can move this centre and a later one, in metres: each by 2^-24 of a coordinate at most. A
// periodic box adds 2^-24 of up to four periods: one for an image, which is a period farther out, one for a centre that
// was wrapped since, two for the way between images. All times 1.25.
FN float centre_rounding(vec4 centre, ContactParams c) {
  EXACT float sum = larger(centre.x, -centre.x) + larger(centre.y, -centre.y) + larger(centre.z, -centre.z);
  EXACT float rounding = sum * bits_float(0x34200000u) + c.box_low.w;  // 1.25 * 2^-23
  return rounding;
}
FN float squared_between(vec4 a, vec4 b, ContactParams c) {
  EXACT float x = nearest_way(a.x, b.x, c.box_low.x, c.box_high.x);
  EXACT float y = nearest_way(a.y, b.y, c.box_low.y, c.box_high.y);
  EXACT float z = nearest_way(a.z, b.z, c.box_low.z, c.box_high.z);
  EXACT float square = (x * x + y * y) + z * z;
  return square;
}
// Whether two spheres are certainly apart; never true of spheres that gap_between finds in contact. With u = 2^-24, r
// the sum of the radii and s the sum of all six coordinates without signs: gaps are cut off to 2^-29 of r, so integers
// in contact are within r(1 + u/16). Centres are the nearest floats, at the start within half a unit of length
// (r * u/128), hence within r(1 + u/8) + u * s, and their square as computed is below that of this bound times 1 + 5u.
// Here s is taken 1.25u times, which covers the roundings of its sum; 1 + 16u covers u/8, 5u/2 and 5u/2 for the
// roundings of reach and its square.
FN bool is_apart(vec4 a, vec4 b, ContactParams c) {
  EXACT float rounding = (centre_rounding(a, c) + centre_rounding(b, c)) * 0.5f;
  EXACT float reach = ((a.w + b.w) + rounding) * bits_float(0x3F800008u);  // 1 + 2^-20
  EXACT float farthest = reach * reach;
  return squared_between(a, b, c) > farthest;
}
FN float free_path(vec4 sphere, vec4 grown, ContactParams c) {
  EXACT float skin = (grown.w - sphere.w) * bits_float(0x3F7F8000u);  // 1 - 2^-9, for the rounding of this and of radii
  EXACT float path = skin - centre_rounding(sphere, c);
  return path;
}
// Whether a sphere has left its skin, or rounding takes half of the skin. In the latter case the next step lists pairs
// and finds the sphere too far out. So a run ends in the same step wherever it was cut, since a cut lists pairs, too.
FN bool has_left_skin(vec4 sphere, vec4 grown, ContactParams c) {
  float path = free_path(sphere, grown, c);
  EXACT float longest = path * path;
  return !(centre_rounding(sphere, c) < path && squared_between(sphere, grown, c) <= longest);
}
// Whether a sphere is too far from the origin for its radius: rounding takes more than half of the skin. Then
// has_left_skin is true, too.
FN bool is_too_far(vec4 sphere, ContactParams c) {
  EXACT float half_skin = sphere.w * c.skin * 0.5f;
  return !(centre_rounding(sphere, c) < half_skin);
}

#endif
