// SPDX-License-Identifier: MIT
// Ambient occlusion and shadows by the spheres themselves, found through the dense cells of the grid, level by level.
// Contributions of many spheres are summed in integers, so that their order changes no bit.
#ifndef SPHEREPAIR_LIGHT_H
#define SPHEREPAIR_LIGHT_H

#include "common/shared/cell.h"
#include "common/shared/draw.h"

#define ON_GROUND 0xFFFFFFFFu  // instead of a sphere index

// A point in the world, in metres, and the normal there.
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

// Returns the depth of the ground along the ray, as depth_of_hit does; 0 if the ray misses the ground.
FN float along_normal(float x, float y, float z, View v) {
  EXACT float sum = (x * v.ground.x + y * v.ground.y) + z * v.ground.z;
  return sum;
}
FN float depth_of_ground(Ray ray, View v) {
  float right = along_normal(v.right.x, v.right.y, v.right.z, v);
  float up = along_normal(v.up.x, v.up.y, v.up.z, v);
  float forward = along_normal(v.forward.x, v.forward.y, v.forward.z, v);
  EXACT float down = 0.0f - to_world(ray.x, ray.y, 1.0f, right, up, forward);
  EXACT float height = along_normal(v.eye.x, v.eye.y, v.eye.z, v) - v.ground.w;
  if (down < bits_float(0x3A800000u) || height <= 0.0f) return 0.0f;  // 2^-10: almost level
  EXACT float depth = (height * same_reciprocal(down)) * ray.a;
  EXACT float least = v.eye.w * ray.a;
  return depth >= least ? depth : 0.0f;
}

// Returns the hit, moved along the normal onto the plane, which the rounded depth may have missed.
FN Surface ground_at(Ray ray, float depth, View v) {
  EXACT float t = depth * same_reciprocal(ray.a);
  EXACT float x = v.eye.x + t * to_world(ray.x, ray.y, 1.0f, v.right.x, v.up.x, v.forward.x);
  EXACT float y = v.eye.y + t * to_world(ray.x, ray.y, 1.0f, v.right.y, v.up.y, v.forward.y);
  EXACT float z = v.eye.z + t * to_world(ray.x, ray.y, 1.0f, v.right.z, v.up.z, v.forward.z);
  EXACT float off = v.ground.w - along_normal(x, y, z, v);
  EXACT float at_x = x + off * v.ground.x;
  EXACT float at_y = y + off * v.ground.y;
  EXACT float at_z = z + off * v.ground.z;
  Surface surface = {at_x, at_y, at_z, v.ground.x, v.ground.y, v.ground.z, ON_GROUND};
  return surface;
}

// Returns the share of the ambient light that a sphere occludes, in 2^-16: its solid angle times the cosine. The share
// fades to 0 at OCCLUSION_RADII of the sphere's radii, whatever the cells.
FN float occlusion_fade(float radius, GridParams g) {
  if (g.occlusion_fade != 0.0f) return g.occlusion_fade;
  EXACT float range = radius * float(OCCLUSION_RADII);
  EXACT float square = range * range;
  return same_reciprocal(larger(square, bits_float(0x0D800000u)));
}
FN uint taken_by(vec4 sphere, Surface s, GridParams g) {
  EXACT float x = sphere.x - s.x;
  EXACT float y = sphere.y - s.y;
  EXACT float z = sphere.z - s.z;
  EXACT float square = (x * x + y * y) + z * z;
  EXACT float facing = (x * s.normal_x + y * s.normal_y) + z * s.normal_z;
  EXACT float left = 1.0f - square * occlusion_fade(sphere.w, g);
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
// Clamps a coordinate to the grid: spheres beyond the border belong to its cells.
FN uint clamped_cell(float coordinate, uint cells) {
  return uint(smaller(larger(coordinate, 0.0f), float(cells - 1u)));
}

FN float coordinate_in_level(float x, float origin, DenseLevel l) {
  EXACT float offset = x - origin;
  EXACT float coordinate = offset * l.scale;
  return coordinate;
}
FN GridPosition position_in_level(Surface s, DenseLevel l, GridParams g) {
  GridPosition position = {coordinate_in_level(s.x, g.origin_x, l), coordinate_in_level(s.y, g.origin_y, l),
                           coordinate_in_level(s.z, g.origin_z, l)};
  return position;
}

struct CellBox {
  CellRange x, y, z;
};

// Returns the cells along an axis that may hold occluders of ambient light.
FN CellRange cells_around(float coordinate, uint cells) {
  EXACT float low = coordinate - 2.0f;
  EXACT float high = coordinate + 2.0f;
  CellRange range = {clamped_cell(low, cells), clamped_cell(high, cells)};
  return range;
}
FN CellBox box_around(GridPosition at, DenseLevel l) {
  CellBox box = {cells_around(at.x, l.cells_x), cells_around(at.y, l.cells_y), cells_around(at.z, l.cells_z)};
  return box;
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

// Returns the axis along which the sun is farthest: 0, 1, 2 for x, y, z. The way to the sun is followed through layers
// of cells along this axis.
FN uint layer_axis(View v) {
  float x = magnitude(v.sun.x);
  float y = magnitude(v.sun.y);
  float z = magnitude(v.sun.z);
  if (y >= x && y >= z) return 1u;
  return x >= z ? 0u : 2u;
}
FN float on_axis(uint axis, float x, float y, float z) { return axis == 0u ? x : axis == 1u ? y : z; }

struct SunWay {
  uint axis, layers, first;  // first: number of the first layer, counted towards the sun
  bool ascends;
  float start, x, y, z;  // start along the axis, in layers; cells that the ray goes along each axis a layer
};
FN SunWay way_to_sun(GridPosition at, DenseLevel l, View v) {
  uint axis = layer_axis(v);
  uint layers = axis == 0u ? l.cells_x : axis == 1u ? l.cells_y : l.cells_z;
  float along = on_axis(axis, v.sun.x, v.sun.y, v.sun.z);
  float start = on_axis(axis, at.x, at.y, at.z);
  bool ascends = along > 0.0f;
  EXACT float before = start + (ascends ? -1.0f : 1.0f);
  uint layer = clamped_cell(before, layers);
  float per_layer = same_reciprocal(magnitude(along));
  EXACT float x = v.sun.x * per_layer;
  EXACT float y = v.sun.y * per_layer;
  EXACT float z = v.sun.z * per_layer;
  SunWay way = {axis, layers, ascends ? layer : layers - 1u - layer, ascends, start, x, y, z};
  return way;
}

// Returns the cells of one layer, along another axis, that the ray to the sun passes through. passed: layers from the
// ray's start to the layer's lower border.
FN CellRange cells_on_way(float coordinate, float slope, float passed, uint cells) {
  EXACT float first = larger(passed - 1.0f, 0.0f);
  EXACT float last = larger(passed + 2.0f, 0.0f);
  EXACT float from = coordinate + slope * first;
  EXACT float to = coordinate + slope * last;
  EXACT float low = smaller(from, to) - 1.0f;
  EXACT float high = larger(from, to) + 1.0f;
  CellRange range = {clamped_cell(low, cells), clamped_cell(high, cells)};
  return range;
}
FN CellBox box_on_way(SunWay way, uint k, GridPosition at, DenseLevel l) {
  uint layer = way.ascends ? k : way.layers - 1u - k;
  EXACT float ahead = float(layer) - way.start;
  EXACT float behind = (way.start - float(layer)) - 1.0f;
  float passed = way.ascends ? ahead : behind;
  CellRange own = {layer, layer};
  CellRange x = cells_on_way(at.x, way.x, passed, l.cells_x);
  CellRange y = cells_on_way(at.y, way.y, passed, l.cells_y);
  CellRange z = cells_on_way(at.z, way.z, passed, l.cells_z);
  CellBox box = {x, y, z};
  if (way.axis == 0u) box.x = own;
  if (way.axis == 1u) box.y = own;
  if (way.axis == 2u) box.z = own;
  return box;
}

// Returns a pixel of the ground: the background, darkened by occlusion and shadow.
FN uint ground_colour(float around, float sun, View v) {
  EXACT float light = (0.5f + 0.5f * around) * (v.sun.w + (1.0f - v.sun.w) * sun);
  return lit(v.background, light);
}

#endif
