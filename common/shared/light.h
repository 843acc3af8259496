// SPDX-License-Identifier: MIT
// Ambient occlusion and shadows from the spheres themselves, found through the dense cells of the grid. What many
// spheres contribute is summed in integers, so that their order changes no bit.
#ifndef SPHEREPAIR_LIGHT_H
#define SPHEREPAIR_LIGHT_H

#include "common/shared/cell.h"
#include "common/shared/draw.h"

#define ON_GROUND 0xFFFFFFFFu  // in place of a sphere index

// A point in the world, metres, and the normal there.
struct Surface {
  float x, y, z, normal_x, normal_y, normal_z;
  uint sphere;
};

FN float to_world(float across, float above, float ahead, float right, float up, float forward) {
  EXACT float sum = (across * right + above * up) + ahead * forward;
  return sum;
}

FN Surface surface_of(vec4 sphere, uint index, Normal normal, View v) {
  EXACT float x = to_world(normal.x, normal.y, normal.z, v.right.x, v.up.x, v.forward.x);
  EXACT float y = to_world(normal.x, normal.y, normal.z, v.right.y, v.up.y, v.forward.y);
  EXACT float z = to_world(normal.x, normal.y, normal.z, v.right.z, v.up.z, v.forward.z);
  EXACT float at_x = sphere.x + sphere.w * x;
  EXACT float at_y = sphere.y + sphere.w * y;
  EXACT float at_z = sphere.z + sphere.w * z;
  Surface surface = {at_x, at_y, at_z, x, y, z, index};
  return surface;
}

// The depth of the ground along the ray, as in depth_of_hit; 0 when the ray does not hit it.
FN float depth_of_ground(Ray ray, float plane, View v) {
  EXACT float down = 0.0f - to_world(ray.x, ray.y, 1.0f, v.right.y, v.up.y, v.forward.y);
  EXACT float height = v.eye.y - plane;
  if (down < bits_float(0x3A800000u) || height <= 0.0f) return 0.0f;  // 2^-10: almost level
  EXACT float depth = (height * same_reciprocal(down)) * ray.a;
  EXACT float least = v.eye.w * ray.a;
  return depth >= least ? depth : 0.0f;
}

FN Surface ground_at(Ray ray, float depth, float plane, View v) {
  EXACT float t = depth * same_reciprocal(ray.a);
  EXACT float x = v.eye.x + t * to_world(ray.x, ray.y, 1.0f, v.right.x, v.up.x, v.forward.x);
  EXACT float z = v.eye.z + t * to_world(ray.x, ray.y, 1.0f, v.right.z, v.up.z, v.forward.z);
  Surface surface = {x, plane, z, 0.0f, 1.0f, 0.0f, ON_GROUND};
  return surface;
}

// The share of the ambient light that a sphere occludes, in 2^-16: its solid angle times the cosine, fading out towards
// OCCLUSION_RADII, whatever the cells.
FN uint taken_by(vec4 sphere, Surface s, GridParams g) {
  EXACT float x = sphere.x - s.x;
  EXACT float y = sphere.y - s.y;
  EXACT float z = sphere.z - s.z;
  EXACT float square = (x * x + y * y) + z * z;
  EXACT float facing = (x * s.normal_x + y * s.normal_y) + z * s.normal_z;
  EXACT float left = 1.0f - square * g.occlusion_fade;
  if (facing <= 0.0f || left <= 0.0f || square < bits_float(0x0D800000u)) return 0u;
  EXACT float per_square = same_reciprocal(square);
  EXACT float cosine = (facing * same_root(square)) * per_square;
  EXACT float taken = ((sphere.w * sphere.w) * per_square) * (cosine * left);
  EXACT float counted = smaller(taken, 1.0f) * 65536.0f;
  return uint(counted);
}
FN float light_left(uint taken) {
  EXACT float divisor = 1.0f + float(taken) * bits_float(0x37C00000u);  // 1.5 * 2^-16
  return same_reciprocal(divisor);
}

struct CellRange {
  uint low, high;
};
// Spheres beyond the border belong to its cells.
FN uint clamped_cell(float coordinate, uint cells) {
  return uint(smaller(larger(coordinate, 0.0f), float(cells - 1u)));
}

FN float grid_coordinate_unclamped(float x, float origin, GridParams g) {
  EXACT float offset = x - origin;
  EXACT float coordinate = offset * g.cells_per_metre;
  return coordinate;
}

// Along an axis: the cells that may hold occluders of ambient light; the first layer that may cast shadows.
FN CellRange cells_around(float coordinate, uint cells) {
  EXACT float low = coordinate - 2.0f;
  EXACT float high = coordinate + 2.0f;
  CellRange range = {clamped_cell(low, cells), clamped_cell(high, cells)};
  return range;
}
FN uint first_layer(float coordinate, uint cells) {
  EXACT float below = coordinate - 1.0f;
  return clamped_cell(below, cells);
}

// Whether the ray from the point to the sun hits the sphere.
FN bool shades(vec4 sphere, Surface s, View v) {
  EXACT float x = sphere.x - s.x;
  EXACT float y = sphere.y - s.y;
  EXACT float z = sphere.z - s.z;
  EXACT float along = (x * v.sun.x + y * v.sun.y) + z * v.sun.z;
  EXACT float a = y * v.sun.z - z * v.sun.y;
  EXACT float b = z * v.sun.x - x * v.sun.z;
  EXACT float c = x * v.sun.y - y * v.sun.x;
  EXACT float off = (a * a + b * b) + c * c;
  EXACT float reach = sphere.w * sphere.w;
  return along > 0.0f && off < reach;
}

// Cells of one layer that the ray to the sun passes through, along another axis.
FN CellRange cells_on_way(float coordinate, float start, float slope, float layer, uint cells) {
  EXACT float first = larger((layer - start) - 1.0f, 0.0f);
  EXACT float last = larger((layer - start) + 2.0f, 0.0f);
  EXACT float from = coordinate + slope * first;
  EXACT float to = coordinate + slope * last;
  EXACT float low = smaller(from, to) - 1.0f;
  EXACT float high = larger(from, to) + 1.0f;
  CellRange range = {clamped_cell(low, cells), clamped_cell(high, cells)};
  return range;
}
FN float slope_of(float along, View v) {
  EXACT float slope = along * same_reciprocal(v.sun.y);
  return slope;
}

// A pixel of the ground: the background, darkened by occlusion and shadow.
FN uint ground_colour(float around, float sun, View v) {
  EXACT float light = (0.5f + 0.5f * around) * (v.sun.w + (1.0f - v.sun.w) * sun);
  return lit(v.background, light);
}

#endif
