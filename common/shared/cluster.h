// SPDX-License-Identifier: MIT
// Culling of clusters of spheres. All tests are conservative, with margins for every rounding, so that culling changes
// no bit of the image.
#ifndef SPHEREPAIR_CLUSTER_H
#define SPHEREPAIR_CLUSTER_H

#include "common/shared/cell.h"
#include "common/shared/draw.h"

// A cluster's bounding box in the camera's axes: centre and half extents.
struct Solid {
  float x, y, z, across, above, ahead;
};

// Whether a view may draw the sphere (in_camera). Others do not enlarge a cluster's box.
FN bool ever_drawable(vec4 sphere) {
  float most = bits_float(0x59800000u);  // 2^52
  return sphere.w >= bits_float(0x30800000u) && sphere.w <= most && magnitude(sphere.x) <= most &&
         magnitude(sphere.y) <= most && magnitude(sphere.z) <= most;
}

FN vec4 lowest_corner(vec4 sphere) {
  EXACT float x = sphere.x - sphere.w;
  EXACT float y = sphere.y - sphere.w;
  EXACT float z = sphere.z - sphere.w;
  vec4 corner = {x, y, z, 0.0f};
  return corner;
}
FN vec4 highest_corner(vec4 sphere) {
  EXACT float x = sphere.x + sphere.w;
  EXACT float y = sphere.y + sphere.w;
  EXACT float z = sphere.z + sphere.w;
  vec4 corner = {x, y, z, 0.0f};
  return corner;
}

// Whether all spheres from a to b in cell order are in one row of cells, none of them at the grid's border, where cells
// are unbounded.
FN bool within_row(GridPosition a, GridPosition b, GridParams g) {
  return uint(a.y) == uint(b.y) && uint(a.z) == uint(b.z) && a.x >= 1.0f && b.x < float(g.cells_x - 1u) &&
         a.y >= 1.0f && a.y < float(g.cells_y - 1u) && a.z >= 1.0f && a.z < float(g.cells_z - 1u);
}
// Bounds along an axis: below the spheres in this cell and after it, and above the spheres in cells before it. 2^-20
// covers the rounding of a coordinate.
FN float least_from(uint cell, float origin, GridParams g) {
  EXACT float offset = float(cell) / g.cells_per_metre;
  EXACT float room = (magnitude(origin) + offset) * bits_float(0x35800000u);
  EXACT float least = ((origin + offset) - room) - g.largest_radius;
  return least;
}
FN float most_before(uint cell, float origin, GridParams g) {
  EXACT float offset = float(cell) / g.cells_per_metre;
  EXACT float room = (magnitude(origin) + offset) * bits_float(0x35800000u);
  EXACT float most = ((origin + offset) + room) + g.largest_radius;
  return most;
}
FN vec4 lowest_in_row(GridPosition a, GridParams g) {
  vec4 corner = {least_from(uint(a.x), g.origin_x, g), least_from(uint(a.y), g.origin_y, g),
                 least_from(uint(a.z), g.origin_z, g), 0.0f};
  return corner;
}
FN vec4 highest_in_row(GridPosition b, GridParams g) {
  vec4 corner = {most_before(uint(b.x) + 1u, g.origin_x, g), most_before(uint(b.y) + 1u, g.origin_y, g),
                 most_before(uint(b.z) + 1u, g.origin_z, g), 0.0f};
  return corner;
}

// Returns the box in the camera's axes. 2^-19 of the sum of a coordinate's terms covers its rounding, here and in
// in_camera.
FN Solid solid_of(vec4 low, vec4 high, View v) {
  EXACT float x = 0.5f * (low.x + high.x) - v.eye.x;
  EXACT float y = 0.5f * (low.y + high.y) - v.eye.y;
  EXACT float z = 0.5f * (low.z + high.z) - v.eye.z;
  EXACT float half_x = 0.5f * (high.x - low.x);
  EXACT float half_y = 0.5f * (high.y - low.y);
  EXACT float half_z = 0.5f * (high.z - low.z);
  EXACT float all = ((magnitude(x) + magnitude(y)) + magnitude(z)) + ((half_x + half_y) + half_z);
  EXACT float far_eye = (all + magnitude(v.eye.x)) + (magnitude(v.eye.y) + magnitude(v.eye.z));
  EXACT float room = far_eye * bits_float(0x36000000u);  // 2^-19
  EXACT float right = (x * v.right.x + y * v.right.y) + z * v.right.z;
  EXACT float up = (x * v.up.x + y * v.up.y) + z * v.up.z;
  EXACT float forward = (x * v.forward.x + y * v.forward.y) + z * v.forward.z;
  EXACT float across =
      ((magnitude(v.right.x) * half_x + magnitude(v.right.y) * half_y) + magnitude(v.right.z) * half_z) + room;
  EXACT float above = ((magnitude(v.up.x) * half_x + magnitude(v.up.y) * half_y) + magnitude(v.up.z) * half_z) + room;
  EXACT float ahead =
      ((magnitude(v.forward.x) * half_x + magnitude(v.forward.y) * half_y) + magnitude(v.forward.z) * half_z) + room;
  Solid solid = {right, up, forward, across, above, ahead};
  return solid;
}

FN bool outside(Solid solid, View v) {
  EXACT float far = solid.z + solid.ahead;
  EXACT float sideways = magnitude(solid.x) - solid.across;
  EXACT float over = magnitude(solid.y) - solid.above;
  EXACT float wide = v.half_x * far;
  EXACT float tall = v.half_y * far;
  return far <= v.eye.w || sideways > wide || over > tall;
}

FN bool reaches_eye_plane(Solid solid) {
  EXACT float close = solid.z - solid.ahead;
  EXACT float least = solid.ahead * bits_float(0x3A800000u);  // 2^-10
  return close <= least;
}

FN Box box_of_solid(Solid solid, View v) {
  EXACT float left = solid.x - solid.across;
  EXACT float right = solid.x + solid.across;
  EXACT float bottom = solid.y - solid.above;
  EXACT float top = solid.y + solid.above;
  EXACT float close = solid.z - solid.ahead;
  EXACT float far = solid.z + solid.ahead;
  return box_between(left, right, bottom, top, close, far, v);
}

FN uint least_depth(Solid solid, Box box, View v) {
  EXACT float close = solid.z - solid.ahead;
  EXACT float far = solid.z + solid.ahead;
  return least_depth_between(close, far, 0.0f, box, v);
}

// Returns the box, moved towards the eye by NEAR_LAYERS times the smallest half extent of its corners. If it is still
// behind the visible depths, its cluster is deferred.
FN Solid brought_nearer(Solid solid, vec4 low, vec4 high) {
  EXACT float width = high.x - low.x;
  EXACT float height = high.y - low.y;
  EXACT float depth = high.z - low.z;
  EXACT float layers = (0.5f * NEAR_LAYERS) * smaller(smaller(width, height), depth);
  EXACT float z = solid.z - layers;
  Solid nearer = {solid.x, solid.y, z, solid.across, solid.above, solid.ahead};
  return nearer;
}

// Corners of bundles are stored after those of all clusters.
FN uint bundles_of(View v) { return (v.clusters + BUNDLE - 1u) / BUNDLE; }
FN uint corners_of_bundle(uint bundle, View v) { return 2u * (v.clusters + bundle); }

// Packs a bundle into one word: its index, and a bit for each of its clusters.
FN uint all_of_bundle(uint bundle, View v) {
  uint clusters = v.clusters - bundle * BUNDLE;
  uint bits = clusters < BUNDLE ? (1u << clusters) - 1u : (1u << BUNDLE) - 1u;
  return (bundle << BUNDLE) | bits;
}
FN uint bundle_in(uint entry) { return entry >> BUNDLE; }
FN uint bits_in(uint entry) { return entry & ((1u << BUNDLE) - 1u); }

// Returns the list that a phase draws.
FN uint list_of(uint phase) { return phase == uint(PHASE_FAR) ? LIST_FAR : LIST_DRAWN; }

// The levels of the hierarchical Z: texels of LEVEL_0, LEVEL_1 and LEVEL_2 pixels along both axes.
FN uint texel_shift(uint level) { return 3u + 2u * level; }
FN uint texels_along(uint pixels, uint level) {
  return (pixels + (1u << texel_shift(level)) - 1u) >> texel_shift(level);
}
FN uint first_texel(uint level, View v) {
  uint first = 0u;
  for (uint k = 0u; k < level; ++k) first += texels_along(v.width, k) * texels_along(v.height, k);
  return first;
}
// Makes a texel: x is the greatest depth of its pixels, infinite for background; y is the greatest without background.
FN uvec2 texel_of_pixel(uint depth) {
  uvec2 texel = {depth, depth == 0xFFFFFFFFu ? 0u : depth};
  return texel;
}
FN uvec2 texel_of_both(uvec2 a, uvec2 b) {
  uvec2 texel = {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y};
  return texel;
}

// Bounds the texels that a box covers, without those that its borders only touch. Rows of spheres have long, low boxes.
FN uint texels_of(Box box, uint level) {
  uint shift = texel_shift(level);
  return ((box.width >> shift) + 1u) * ((box.height >> shift) + 1u);
}
FN uint level_for(Box box) { return texels_of(box, 0u) > uint(TEXELS_AT_MOST) ? 1u : 0u; }

#endif
