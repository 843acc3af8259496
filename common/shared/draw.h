// SPDX-License-Identifier: MIT
// Geometry and shading of an image, written once for three compilers. A pixel's ray is t * (x, y, 1) in the camera's
// axes. Within a pixel, b - sqrt(disc) orders the hits as t does, so it is the depth: a positive float, whose bits
// order as it does. Everything that decides a pixel is rounded the same way everywhere. Denormals may be flushed:
// nothing here is so small that it shows.
#ifndef SPHEREPAIR_DRAW_H
#define SPHEREPAIR_DRAW_H

#include "common/shared/round.h"
#include "common/shared/view.h"

// Returns the sphere in the camera's axes, radius in w. w = 0 if it cannot be drawn: a radius outside 2^-30..2^50 m, a
// centre farther than 2^50 m from the eye, or a NaN.
FN vec4 in_camera(vec4 sphere, View v) {
  EXACT float x = sphere.x - v.eye.x;
  EXACT float y = sphere.y - v.eye.y;
  EXACT float z = sphere.z - v.eye.z;
  EXACT float across = (x * v.right.x + y * v.right.y) + z * v.right.z;
  EXACT float above = (x * v.up.x + y * v.up.y) + z * v.up.z;
  EXACT float ahead = (x * v.forward.x + y * v.forward.y) + z * v.forward.z;
  float most = bits_float(0x58800000u);  // 2^50
  bool drawable = sphere.w >= bits_float(0x30800000u) && sphere.w <= most && x >= -most && x <= most && y >= -most &&
                  y <= most && z >= -most && z <= most;
  vec4 seen = {across, above, ahead, drawable ? sphere.w : 0.0f};
  return seen;
}

FN float magnitude(float x) { return bits_float(float_bits(x) & 0x7FFFFFFFu); }

// Whether the frustum may hold the sphere. Its borders are a pixel wider than the image, which covers the rounding.
FN bool in_frustum(vec4 seen, View v) {
  EXACT float far = seen.z + seen.w;
  EXACT float sideways = magnitude(seen.x) - v.half_x * seen.z;
  EXACT float over = magnitude(seen.y) - v.half_y * seen.z;
  EXACT float room_x = seen.w * v.norm_x;
  EXACT float room_y = seen.w * v.norm_y;
  return seen.w > 0.0f && far > v.eye.w && sideways <= room_x && over <= room_y;
}

// The pixels x .. x + width - 1, y .. y + height - 1. A width or height of 0: none.
struct Box {
  uint x, y, width, height;
};

// Return the first pixel with its centre within low .. high along an axis, and one past the last. The margin of 1/64
// pixel covers the rounding of low and high, with any driver's division, up to 16,384 pixels; a wider range only costs
// time.
FN uint first_pixel(float low) {
  EXACT float margin = low - 0.015625f;
  EXACT float before = larger(margin, -1.0f) + 1.0f;
  return uint(before);
}
FN uint last_pixel(float high, uint size) {
  EXACT float margin = high + 0.015625f;
  EXACT float inside = smaller(margin, float(size - 1u)) + 1.0f;
  return uint(larger(inside, 0.0f));  // one past the last
}

// Returns the bounding box, in pixels, of a box in the camera's axes.
FN Box box_between(float left, float right, float bottom, float top, float close, float far, View v) {
  EXACT float per_close = v.focal / close;
  EXACT float per_far = v.focal / far;
  EXACT float low_x = left * (left < 0.0f ? per_close : per_far) + v.centre_x;
  EXACT float high_x = right * (right > 0.0f ? per_close : per_far) + v.centre_x;
  EXACT float low_y = v.centre_y - top * (top > 0.0f ? per_close : per_far);
  EXACT float high_y = v.centre_y - bottom * (bottom < 0.0f ? per_close : per_far);
  uint end_x = last_pixel(high_x, v.width);
  uint end_y = last_pixel(high_y, v.height);
  uint x = first_pixel(smaller(low_x, float(v.width)));
  uint y = first_pixel(smaller(low_y, float(v.height)));
  Box box = {x, y, end_x > x ? end_x - x : 0u, end_y > y ? end_y - y : 0u};
  return box;
}

FN Box box_of(vec4 seen, View v) {
  Box all = {0u, 0u, v.width, v.height};
  EXACT float close = seen.z - seen.w;
  EXACT float far = seen.z + seen.w;
  EXACT float least = seen.w * bits_float(0x3A800000u);  // 2^-10
  EXACT float left = seen.x - seen.w;
  EXACT float right = seen.x + seen.w;
  EXACT float bottom = seen.y - seen.w;
  EXACT float top = seen.y + seen.w;
  if (close <= least) return all;  // it crosses the plane of the eye
  return box_between(left, right, bottom, top, close, far, v);
}

// Packs a box into two words.
FN uvec2 words_of(Box box) {
  uvec2 words = {box.x | (box.y << 16), box.width | (box.height << 16)};
  return words;
}
FN Box box_from(uvec2 words) {
  Box box = {words.x & 0xFFFFu, words.x >> 16, words.y & 0xFFFFu, words.y >> 16};
  return box;
}

// Whether a box is cut into tiles.
FN bool is_large(Box box, View v) {
  uint most = v.lanes == uint(LANES) ? uint(SHARE_AT_MOST) : uint(WALK_AT_MOST);
  return box.width > most || box.height > most;
}

// Returns how many of the threads that share a sphere are in one row of its box.
FN uint lanes_across(View v) { return v.lanes == 1u ? 1u : uint(LANES_ACROSS); }

// Returns the k-th sphere or cluster in approximate front-to-back order: cell order is by z, then y, then x.
FN uint front_to_back(uint k, uint count, View v) { return v.forward.z < 0.0f ? count - 1u - k : k; }

FN uint tiles_along(uint pixels) { return (pixels + TILE - 1u) / TILE; }
FN Box tile_of(Box box, uint column, uint row) {
  uint x = column * TILE;
  uint y = row * TILE;
  uint width = box.width - x;
  uint height = box.height - y;
  Box tile = {box.x + x, box.y + y, width < TILE ? width : TILE, height < TILE ? height : TILE};
  return tile;
}

struct Ray {
  float x, y, a;  // a: the square of the length of (x, y, 1)
};
FN Ray ray_through(uint px, uint py, View v) {
  EXACT float x = (float(px) - v.centre_x) * v.pixel;
  EXACT float y = (v.centre_y - float(py)) * v.pixel;
  EXACT float a = (x * x + y * y) + 1.0f;
  Ray ray = {x, y, a};
  return ray;
}

// Returns the depth at which the ray enters the sphere; 0 if it does not, or does before v.eye.w. The cross product
// gives the centre's distance from the ray, which avoids a difference of large squares.
FN float depth_of_hit(vec4 seen, Ray ray, View v) {
  EXACT float up = seen.y - ray.y * seen.z;
  EXACT float across = seen.x - ray.x * seen.z;
  EXACT float turn = ray.x * up - ray.y * across;
  EXACT float off = ((bits_float(0x0D800000u) + up * up) + across * across) + turn * turn;  // 2^-100 hides denormals
  EXACT float within = ray.a * (seen.w * seen.w) - off;
  if (within < 0.0f) return 0.0f;
  EXACT float middle = (ray.x * seen.x + ray.y * seen.y) + seen.z;
  EXACT float depth = middle - same_root(within);
  EXACT float least = v.eye.w * ray.a;
  return depth >= least ? depth : 0.0f;
}

struct Range {
  float least, most;
};
// Returns the range of |x| for x from low to high.
FN Range magnitudes(float low, float high) {
  float a = magnitude(low);
  float b = magnitude(high);
  bool across_zero = low <= 0.0f && high >= 0.0f;
  Range range = {across_zero ? 0.0f : smaller(a, b), larger(a, b)};
  return range;
}

// Returns the range of the squared lengths of the rays through a box.
FN Range squares_of_rays(Box box, View v) {
  EXACT float left = (float(box.x) - v.centre_x) * v.pixel;
  EXACT float right = (float(box.x + box.width) - v.centre_x) * v.pixel;
  EXACT float top = (v.centre_y - float(box.y)) * v.pixel;
  EXACT float bottom = (v.centre_y - float(box.y + box.height)) * v.pixel;
  Range x = magnitudes(left, right);
  Range y = magnitudes(bottom, top);
  EXACT float least = (x.least * x.least + y.least * y.least) + 1.0f;
  EXACT float most = (x.most * x.most + y.most * y.most) + 1.0f;
  Range squares = {least, most};
  return squares;
}

// Returns the bits of a lower bound on the depth of anything between these limits along forward, at any pixel of the
// box. A depth is the distance along forward times the square of the ray's length; 2^-16 of the greatest covers its
// rounding.
FN uint least_depth_between(float close, float far, float more_slack, Box box, View v) {
  Range squares = squares_of_rays(box, v);
  EXACT float slack = (far * bits_float(0x37800000u) + more_slack) * squares.most;
  EXACT float least = close * squares.least - slack;
  return least > 0.0f ? float_bits(least) : 0u;
}

// Does the same for a sphere: 2^-10 of the radius covers the rounding of the root where the ray is almost tangent.
FN uint least_depth_of(vec4 seen, Box box, View v) {
  EXACT float close = seen.z - seen.w;
  EXACT float far = seen.z + seen.w;
  EXACT float root = seen.w * bits_float(0x3A800000u);
  return least_depth_between(close, far, root, box, v);
}

// Returns the entry of the palette for a sphere's radius or speed.
FN uint palette_entry(vec4 position, vec4 velocity, View v) {
  EXACT float square = (velocity.x * velocity.x + velocity.y * velocity.y) + velocity.z * velocity.z;
  float value = v.colour_by == COLOUR_BY_RADIUS ? position.w : square;
  uint entry = value >= v.limits_0.x ? 1u : 0u;
  entry += value >= v.limits_0.y ? 1u : 0u;
  entry += value >= v.limits_0.z ? 1u : 0u;
  entry += value >= v.limits_0.w ? 1u : 0u;
  entry += value >= v.limit_4 ? 1u : 0u;
  entry += value >= v.limit_5 ? 1u : 0u;
  return entry + (value >= v.limit_6 ? 1u : 0u);
}

FN uint palette(uint contacts, View v) {
  uint first = contacts < 2u ? (contacts == 0u ? v.palette_0.x : v.palette_0.y)
                             : (contacts == 2u ? v.palette_0.z : v.palette_0.w);
  uint second = contacts < 6u ? (contacts == 4u ? v.palette_4.x : v.palette_4.y)
                              : (contacts == 6u ? v.palette_4.z : v.palette_4.w);
  return contacts < 4u ? first : second;
}

// Converts 0xRRGGBB to the image's byte order, each channel times light, which is at most 1.
FN uint lit(uint colour, float light) {
  EXACT float red = float((colour >> 16) & 255u) * light + 0.5f;
  EXACT float green = float((colour >> 8) & 255u) * light + 0.5f;
  EXACT float blue = float(colour & 255u) * light + 0.5f;
  return uint(red) | (uint(green) << 8) | (uint(blue) << 16) | 0xFF000000u;
}

// The outward normal, in the camera's axes, where the ray hits the sphere at this depth.
struct Normal {
  float x, y, z;
};
FN Normal normal_at(vec4 seen, Ray ray, float depth) {
  EXACT float t = depth * same_reciprocal(ray.a);
  EXACT float per_radius = same_reciprocal(seen.w);
  EXACT float x = (t * ray.x - seen.x) * per_radius;
  EXACT float y = (t * ray.y - seen.y) * per_radius;
  EXACT float z = (t - seen.z) * per_radius;
  Normal normal = {x, y, z};
  return normal;
}

// Returns the light on the surface: ambient light, of which the share `around` arrives, and sunlight, of which the
// share `sun` arrives.
FN float light_on_normal(Normal normal, float around, float sun, View v) {
  EXACT float facing = (normal.x * v.light.x + normal.y * v.light.y) + normal.z * v.light.z;
  EXACT float light = v.light.w * around + ((1.0f - v.light.w) * sun) * smaller(larger(facing, 0.0f), 1.0f);
  return light;
}

FN uint shade(vec4 seen, Ray ray, float depth, uint contacts, View v) {
  return lit(palette(contacts, v), light_on_normal(normal_at(seen, ray, depth), 1.0f, 1.0f, v));
}

#endif
