// SPDX-License-Identifier: MIT
// Periodic boxes of contacts. In integers, centres lie in [low, high) along periodic axes; float32 may round one up to
// high. Of all images of a sphere the one nearest to another pushes it; a box is longer than two reaches, so no other
// one touches it. The search for near pairs sees images as spheres of their own, after the n spheres.
#ifndef SPHEREPAIR_PERIODIC_H
#define SPHEREPAIR_PERIODIC_H

#include "common/shared/contact/fixed.h"
#include "common/shared/layout.h"

// Axes are bits: x, y, z.
FN uint periodic_axes(ContactParams c) {
  return (c.box_low.x < c.box_high.x ? 1u : 0u) | (c.box_low.y < c.box_high.y ? 2u : 0u) |
         (c.box_low.z < c.box_high.z ? 4u : 0u);
}

// How often the box is added to a - b to make the shortest way from b to an image of a: -1, 0 or 1.
FN int nearest_shift(float a, float b, float low, float high) {
  EXACT float way = a - b;
  EXACT float half_period = (high - low) * 0.5f;
  return way > half_period ? -1 : way < -half_period ? 1 : 0;
}
// Returns the shortest way from b to an image of a. Rounding moves it by 2^-24 of a coordinate and of two periods.
FN float nearest_way(float a, float b, float low, float high) {
  EXACT float way = a - b;
  if (low == high) return way;  // not periodic
  EXACT float period = high - low;
  EXACT float nearest = way + float(nearest_shift(a, b, low, high)) * period;
  return nearest;
}
FN int64_t nearest_units(int64_t way, bool periodic, int64_t low, int64_t high) {
  if (!periodic) return way;
  int64_t period = high - low;
  int64_t twice = way + way;
  return twice > period ? way - period : twice < -period ? way + period : way;
}
// Returns a coordinate inside the box, from one that is at most a period outside.
FN int64_t inside_box(int64_t at, bool periodic, int64_t low, int64_t high) {
  if (!periodic) return at;
  return at >= high ? at - (high - low) : at < low ? at + (high - low) : at;
}

// The faces of the box within reach of a sphere, which needs images beyond the opposite ones. Bits: low x, y, z, high
// x, y, z.
FN uint image_faces(vec4 grown, ContactParams c) {
  uint axes = periodic_axes(c);
  EXACT float reach = grown.w + c.box_high.w;
  EXACT float x = grown.x - c.box_low.x;
  EXACT float y = grown.y - c.box_low.y;
  EXACT float z = grown.z - c.box_low.z;
  EXACT float to_x = c.box_high.x - grown.x;
  EXACT float to_y = c.box_high.y - grown.y;
  EXACT float to_z = c.box_high.z - grown.z;
  uint low = (x < reach ? 1u : 0u) | (y < reach ? 2u : 0u) | (z < reach ? 4u : 0u);
  uint high = (to_x < reach ? 1u : 0u) | (to_y < reach ? 2u : 0u) | (to_z < reach ? 4u : 0u);
  return (low & axes) | ((high & axes) << 3);
}

// An image is the sphere plus -1, 0 or 1 boxes along each axis. Of an image and its opposite, one is enough to find all
// pairs: images 14 to 26, where the first axis that is not 0 has 1.
#define FIRST_IMAGE 14u
#define END_OF_IMAGES 27u
FN int image_shift(uint image, uint axis) {
  return int(axis == 0u ? image / 9u : axis == 1u ? image / 3u % 3u : image % 3u) - 1;
}
FN bool image_is_needed(uint image, uint faces) {
  uint needed = 0u;
  for (uint axis = 0u; axis < 3u; ++axis) {
    int shift = image_shift(image, axis);
    needed |= shift == 0 ? 0u : 1u << (shift > 0 ? axis : axis + 3u);
  }
  return (needed & faces) == needed;
}
FN int64_t image_units(int64_t at, int shift, int64_t low, int64_t high) {
  return shift == 0 ? at : shift > 0 ? at + (high - low) : at - (high - low);
}

#endif
