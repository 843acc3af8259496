// SPDX-License-Identifier: MIT
// One thread per pixel, in place of draw_resolve: shading with ambient occlusion and shadows by other spheres, and the
// ground.
#include "common/shared/light.h"
#include "cuda/kernels.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

// The sphere at index k in cell order; the surface's own sphere does not occlude it.
__device__ inline vec4 found_at(const Params& p, const KernelBuffers& buf, uint k) {
  return index_source(p) != 0u ? buf.sorted[k] : buf.position[k];
}
__device__ inline bool is_own(const Params& p, const KernelBuffers& buf, vec4 found, uint k, Surface s) {
  return sphere_index(p, buf, found, k) == s.sphere;
}

__device__ inline float light_around(const Params& p, const KernelBuffers& buf, Surface s) {
  float x = grid_coordinate_unclamped(s.x, p.grid.origin_x, p.grid);
  float y = grid_coordinate_unclamped(s.y, p.grid.origin_y, p.grid);
  float z = grid_coordinate_unclamped(s.z, p.grid.origin_z, p.grid);
  CellRange row_x = cells_around(x, p.grid.cells_x);
  CellRange row_y = cells_around(y, p.grid.cells_y);
  CellRange row_z = cells_around(z, p.grid.cells_z);
  uint taken = 0u;
  for (uint z_cell = row_z.low; z_cell <= row_z.high; ++z_cell)
    for (uint y_cell = row_y.low; y_cell <= row_y.high; ++y_cell) {
      uint row = dense_slot(0u, y_cell, z_cell, p.grid);
      for (uint k = buf.cell[row + row_x.low]; k < buf.cell[row + row_x.high + 1u]; ++k) {
        vec4 found = found_at(p, buf, k);
        if (!is_own(p, buf, found, k, s)) taken += taken_by(with_radius(p, found), s, p.grid);
      }
    }
  return light_left(taken);
}

__device__ inline bool in_shadow(const Params& p, const KernelBuffers& buf, const View& v, Surface s) {
  float x = grid_coordinate_unclamped(s.x, p.grid.origin_x, p.grid);
  float y = grid_coordinate_unclamped(s.y, p.grid.origin_y, p.grid);
  float z = grid_coordinate_unclamped(s.z, p.grid.origin_z, p.grid);
  for (uint layer = first_layer(y, p.grid.cells_y); layer < p.grid.cells_y; ++layer) {
    CellRange row_x = cells_on_way(x, y, slope_of(v.sun.x, v), float(layer), p.grid.cells_x);
    CellRange row_z = cells_on_way(z, y, slope_of(v.sun.z, v), float(layer), p.grid.cells_z);
    for (uint z_cell = row_z.low; z_cell <= row_z.high; ++z_cell) {
      uint row = dense_slot(0u, layer, z_cell, p.grid);
      for (uint k = buf.cell[row + row_x.low]; k < buf.cell[row + row_x.high + 1u]; ++k) {
        vec4 found = found_at(p, buf, k);
        if (shades(with_radius(p, found), s, v) && !is_own(p, buf, found, k, s)) return true;
      }
    }
  }
  return false;
}

__global__ void __launch_bounds__(BLOCK) draw_light(Params p, KernelBuffers buf, View v) {
  uint pixel = group_index(p) * BLOCK + threadIdx.x;
  if (pixel >= v.width * v.height) return;
  uvec2 seen = buf.visible[pixel];
  Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  bool sphere = seen.y != 0xFFFFFFFFu;
  float ground = (v.lighting & LIGHT_GROUND) != 0u ? depth_of_ground(ray, p.motion.plane, v) : 0.0f;
  buf.image[pixel] = lit(v.background, 1.0f);
  if (!sphere && ground == 0.0f) return;
  bool on_ground = !sphere || (ground > 0.0f && ground < bits_float(seen.y));
  vec4 shown = in_camera(buf.position[sphere ? seen.x : 0u], v);
  Normal normal = normal_at(shown, ray, bits_float(seen.y));
  Surface s =
      on_ground ? ground_at(ray, ground, p.motion.plane, v) : surface_of(buf.position[seen.x], seen.x, normal, v);
  float around = (v.lighting & LIGHT_OCCLUSION) != 0u ? light_around(p, buf, s) : 1.0f;
  float sun = (v.lighting & LIGHT_SHADOW) != 0u && in_shadow(p, buf, v, s) ? 0.0f : 1.0f;
  buf.image[pixel] = on_ground ? ground_colour(around, sun, v)
                               : lit(palette(buf.count[seen.x], v), light_on_normal(normal, around, sun, v));
}

Entry draw_light_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_light); }

}  // namespace spherepair
