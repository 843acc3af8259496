// SPDX-License-Identifier: MIT
// One thread per pixel, instead of draw_resolve: shades it with ambient occlusion and shadows by other spheres, and
// draws the ground.
#include "common/shared/light.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

// The sphere at index k in cell order, and whether it is the surface's own, which does not occlude it.
__device__ inline vec4 found_at(const Params& p, const KernelBuffers& buf, uint k) {
  return index_source(p) != 0u ? buf.sorted[k] : buf.position[k];
}
__device__ inline bool is_own(const Params& p, const KernelBuffers& buf, vec4 found, uint k, Surface s) {
  return sphere_index(p, buf, found, k) == s.sphere;
}

__device__ inline float light_around(const Params& p, const KernelBuffers& buf, Surface s) {
  uint taken = 0u;
  DenseLevel l = lowest_level(p.grid);
  for (uint level = 0u; level <= p.grid.top_level; ++level, l = level_above(l)) {
    if ((p.grid.levels >> level & 1u) == 0u) continue;
    CellBox box = box_around(position_in_level(s, l, p.grid), l);
    for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
      for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
        uint row = slot_in_level(0u, y_cell, z_cell, l);
        for (uint k = buf.cell[row + box.x.low]; k < buf.cell[row + box.x.high + 1u]; ++k) {
          vec4 found = found_at(p, buf, k);
          if (!is_own(p, buf, found, k, s)) taken += taken_by(with_radius(p, found), s, p.grid);
        }
      }
  }
  return light_left(taken);
}

__device__ inline bool any_shades(const Params& p, const KernelBuffers& buf, const View& v, CellBox box, DenseLevel l,
                                  Surface s) {
  for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
    for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
      uint row = slot_in_level(0u, y_cell, z_cell, l);
      for (uint k = buf.cell[row + box.x.low]; k < buf.cell[row + box.x.high + 1u]; ++k) {
        vec4 found = found_at(p, buf, k);
        if (shades(with_radius(p, found), s, v) && !is_own(p, buf, found, k, s)) return true;
      }
    }
  return false;
}

__device__ inline bool in_shadow(const Params& p, const KernelBuffers& buf, const View& v, Surface s) {
  DenseLevel l = lowest_level(p.grid);
  for (uint level = 0u; level <= p.grid.top_level; ++level, l = level_above(l)) {
    if ((p.grid.levels >> level & 1u) == 0u) continue;
    GridPosition at = position_in_level(s, l, p.grid);
    SunWay way = way_to_sun(at, l, v);
    for (uint k = way.first; k < way.layers; ++k)
      if (any_shades(p, buf, v, box_on_way(way, k, at, l), l, s)) return true;
  }
  return false;
}

__global__ void __launch_bounds__(BLOCK) draw_light(Params p, KernelBuffers buf, View v) {
  uint pixel = group_index(p) * BLOCK + threadIdx.x;
  if (pixel >= v.width * v.height) return;
  uvec2 seen = buf.visible[pixel];
  Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  bool sphere = seen.y != 0xFFFFFFFFu && (v.lighting & LIGHT_ALONE) == 0u;
  float ground = (v.lighting & LIGHT_GROUND) != 0u ? depth_of_ground(ray, v) : 0.0f;
  buf.image[pixel] = lit(v.background, 1.0f);
  if (!sphere && ground == 0.0f) return;
  bool on_ground = !sphere || (ground > 0.0f && ground < bits_float(seen.y));
  vec4 shown = in_camera(buf.position[sphere ? seen.x : 0u], v);
  Normal normal = normal_at(shown, ray, bits_float(seen.y));
  Surface s = on_ground ? ground_at(ray, ground, v) : surface_of(buf.position[seen.x], seen.x, normal, v);
  float around = (v.lighting & LIGHT_OCCLUSION) != 0u ? light_around(p, buf, s) : 1.0f;
  float sun = (v.lighting & LIGHT_SHADOW) != 0u && in_shadow(p, buf, v, s) ? 0.0f : 1.0f;
  buf.image[pixel] = on_ground ? ground_colour(around, sun, v)
                               : lit(palette(buf.count[seen.x], v), light_on_normal(normal, around, sun, v));
}

Entry draw_light_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_light); }

}  // namespace spherepair
