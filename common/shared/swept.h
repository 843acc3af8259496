// SPDX-License-Identifier: MIT
// Continuous collision detection: whether two spheres touch at any time within the next dt while both fall freely. The
// same gravity accelerates both, so their relative path is straight. At its start the test is exact; for the rest it is
// float64 with a margin of 2^-44 of the squares compared, on the side of a contact: no contact is missed, and the bits
// of every operation are fixed, so that every backend finds the same pairs.
#ifndef SPHEREPAIR_SWEPT_H
#define SPHEREPAIR_SWEPT_H

#include "common/shared/exact.h"

FN bool touch_within(vec4 a, vec4 va, vec4 b, vec4 vb, float dt, float scale, float offset) {
  if (decide_pair(a, b, scale, offset).collide) return true;
  double margin = bits_double(0x3D300000u, 0u);  // 2^-44
  EXACT double x = exact_double(a.x) - exact_double(b.x);
  EXACT double y = exact_double(a.y) - exact_double(b.y);
  EXACT double z = exact_double(a.z) - exact_double(b.z);
  EXACT double vx = exact_double(va.x) - exact_double(vb.x);
  EXACT double vy = exact_double(va.y) - exact_double(vb.y);
  EXACT double vz = exact_double(va.z) - exact_double(vb.z);
  EXACT double r = exact_double(a.w) + exact_double(b.w);
  EXACT double q = r * r;
  EXACT double s = (x * x + y * y) + z * z;
  EXACT double speed = (vx * vx + vy * vy) + vz * vz;  // squared
  EXACT double parting = (x * vx + y * vy) + z * vz;   // half of d(distance^2)/dt at the start
  EXACT double parting_error = margin * (s * speed);
  EXACT double parting_square = parting * parting;
  double zero = bits_double(0u, 0u);
  if (!(speed > zero)) return false;
  if (parting > zero && parting_square > parting_error) return false;  // nearest at the start
  double seconds = exact_double(dt);
  EXACT double slowing = speed * seconds;
  if (-parting >= slowing) {  // nearest at the end
    EXACT double end_x = x + vx * seconds;
    EXACT double end_y = y + vy * seconds;
    EXACT double end_z = z + vz * seconds;
    EXACT double end = (end_x * end_x + end_y * end_y) + end_z * end_z;
    EXACT double least = q + margin * ((s + q) + slowing * seconds);
    return !(end > least);
  }
  EXACT double gap = (s - q) - margin * (s + q);
  EXACT double left = gap * speed;
  EXACT double right = parting_square + parting_error;
  return parting < zero ? !(left > right) : !(gap > zero);
}

#endif
