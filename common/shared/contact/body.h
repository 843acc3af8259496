// SPDX-License-Identifier: MIT
// A sphere in 64-bit integers, its centre in float32, and its images in a periodic box.
#ifndef SPHEREPAIR_BODY_H
#define SPHEREPAIR_BODY_H

#include "common/shared/contact/periodic.h"

struct Body {
  int64_t x, y, z, px, py, pz;  // units of length and of momentum
  float radius;                 // metres
};

// Returns the float32 centre nearest to the state.
FN vec4 centre_of(Body s, ContactParams c) {
  float unit = power_of_two(-c.unit_exponent);
  EXACT float x = float_of(s.x) * unit;
  EXACT float y = float_of(s.y) * unit;
  EXACT float z = float_of(s.z) * unit;
  vec4 centre = {x, y, z, s.radius};
  return centre;
}

// Wraps the sphere into the periodic box, given that it is at most a period outside.
FN Body wrapped(Body s, ContactParams c) {
  uint axes = periodic_axes(c);
  s.x = inside_box(s.x, (axes & 1u) != 0u, c.low_x, c.high_x);
  s.y = inside_box(s.y, (axes & 2u) != 0u, c.low_y, c.high_y);
  s.z = inside_box(s.z, (axes & 4u) != 0u, c.low_z, c.high_z);
  return s;
}

// The shortest way from b to an image of a, in units.
struct Ways {
  int64_t x, y, z;
};
FN Ways ways_between(Body a, Body b, ContactParams c) {
  uint axes = periodic_axes(c);
  Ways way = {nearest_units(a.x - b.x, (axes & 1u) != 0u, c.low_x, c.high_x),
              nearest_units(a.y - b.y, (axes & 2u) != 0u, c.low_y, c.high_y),
              nearest_units(a.z - b.z, (axes & 4u) != 0u, c.low_z, c.high_z)};
  return way;
}

// Returns an image of the sphere (periodic.h) with a radius of its own.
FN vec4 sphere_of_image(Body s, uint image, float radius, ContactParams c) {
  s.x = image_units(s.x, image_shift(image, 0u), c.low_x, c.high_x);
  s.y = image_units(s.y, image_shift(image, 1u), c.low_y, c.high_y);
  s.z = image_units(s.z, image_shift(image, 2u), c.low_z, c.high_z);
  s.radius = radius;
  return centre_of(s, c);
}

#endif
