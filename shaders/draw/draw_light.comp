#version 450
// SPDX-License-Identifier: MIT
// One thread per pixel, instead of draw_resolve: shades it with ambient occlusion and shadows by other spheres, and
// draws the ground.
#include "shaders/draw/view.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/kernels.glsl"
#include "common/shared/light.h"

layout(std430, binding = SLOT_SORTED) restrict readonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_VISIBLE) restrict readonly buffer VisibleBuffer { uvec2 visible[]; };
layout(std430, binding = SLOT_IMAGE) restrict writeonly buffer ImageBuffer { uint image[]; };
layout(local_size_x = BLOCK) in;

// The sphere at index k in cell order, and whether it is the surface's own, which does not occlude it.
vec4 found_at(uint k) { return index_source() != 0u ? sorted[k] : position[k]; }
bool is_own(vec4 found, uint k, Surface s) { return sphere_index(found, k) == s.sphere; }

float light_around(Surface s) {
  uint taken = 0u;
  DenseLevel l = lowest_level(p.grid);
  for (uint level = 0u; level <= p.grid.top_level; ++level, l = level_above(l)) {
    if ((p.grid.levels >> level & 1u) == 0u) continue;
    CellBox box = box_around(position_in_level(s, l, p.grid), l);
    for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
      for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
        uint row = slot_in_level(0u, y_cell, z_cell, l);
        for (uint k = cell[row + box.x.low]; k < cell[row + box.x.high + 1u]; ++k) {
          vec4 found = found_at(k);
          if (!is_own(found, k, s)) taken += taken_by(with_radius(found), s, p.grid);
        }
      }
  }
  return light_left(taken);
}

bool any_shades(CellBox box, DenseLevel l, Surface s) {
  for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
    for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
      uint row = slot_in_level(0u, y_cell, z_cell, l);
      for (uint k = cell[row + box.x.low]; k < cell[row + box.x.high + 1u]; ++k) {
        vec4 found = found_at(k);
        if (shades(with_radius(found), s, v) && !is_own(found, k, s)) return true;
      }
    }
  return false;
}

bool in_shadow(Surface s) {
  DenseLevel l = lowest_level(p.grid);
  for (uint level = 0u; level <= p.grid.top_level; ++level, l = level_above(l)) {
    if ((p.grid.levels >> level & 1u) == 0u) continue;
    GridPosition at = position_in_level(s, l, p.grid);
    SunWay way = way_to_sun(at, l, v);
    for (uint k = way.first; k < way.layers; ++k)
      if (any_shades(box_on_way(way, k, at, l), l, s)) return true;
  }
  return false;
}

void main() {
  uint pixel = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (pixel >= v.width * v.height) return;
  uvec2 seen = visible[pixel];
  Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  bool sphere = seen.y != 0xFFFFFFFFu && (v.lighting & LIGHT_ALONE) == 0u;
  float ground = (v.lighting & LIGHT_GROUND) != 0u ? depth_of_ground(ray, v) : 0.0f;
  image[pixel] = lit(v.background, 1.0f);
  if (!sphere && ground == 0.0f) return;
  bool on_ground = !sphere || (ground > 0.0f && ground < bits_float(seen.y));
  vec4 shown = in_camera(position[sphere ? seen.x : 0u], v);
  Normal normal = normal_at(shown, ray, bits_float(seen.y));
  Surface s = on_ground ? ground_at(ray, ground, v) : surface_of(position[seen.x], seen.x, normal, v);
  float around = (v.lighting & LIGHT_OCCLUSION) != 0u ? light_around(s) : 1.0f;
  float sun = (v.lighting & LIGHT_SHADOW) != 0u && in_shadow(s) ? 0.0f : 1.0f;
  image[pixel] = on_ground ? ground_colour(around, sun, v)
                           : lit(palette(count[seen.x], v), light_on_normal(normal, around, sun, v));
}
