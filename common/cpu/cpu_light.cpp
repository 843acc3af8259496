// SPDX-License-Identifier: MIT
#include "common/cpu/cpu_light.h"

namespace spherepair {

CpuLight::CpuLight(std::span<const vec4> spheres, const Params& p)
    : spheres_(spheres), p_(p), begin_(size_t(p.grid.cell_slots) + 2), id_(spheres.size()) {
  for (const vec4& sphere : spheres) ++begin_[slot_of(sphere, p.grid) + 2];
  for (size_t slot = 2; slot < begin_.size(); ++slot) begin_[slot] += begin_[slot - 1];
  for (uint i = 0; i < spheres.size(); ++i) id_[begin_[slot_of(spheres[i], p.grid) + 1]++] = i;
}

float CpuLight::around(const Surface& s) const {
  const float x = grid_coordinate_unclamped(s.x, p_.grid.origin_x, p_.grid),
              y = grid_coordinate_unclamped(s.y, p_.grid.origin_y, p_.grid),
              z = grid_coordinate_unclamped(s.z, p_.grid.origin_z, p_.grid);
  const CellRange row_x = cells_around(x, p_.grid.cells_x), row_y = cells_around(y, p_.grid.cells_y),
                  row_z = cells_around(z, p_.grid.cells_z);
  uint taken = 0;
  for (uint z_cell = row_z.low; z_cell <= row_z.high; ++z_cell)
    for (uint y_cell = row_y.low; y_cell <= row_y.high; ++y_cell) {
      const uint row = dense_slot(0, y_cell, z_cell, p_.grid);
      for (uint k = begin_[row + row_x.low]; k < begin_[row + row_x.high + 1]; ++k)
        if (id_[k] != s.sphere) taken += taken_by(spheres_[id_[k]], s, p_.grid);
    }
  return light_left(taken);
}

bool CpuLight::in_shadow(const Surface& s, const View& v) const {
  const float x = grid_coordinate_unclamped(s.x, p_.grid.origin_x, p_.grid),
              y = grid_coordinate_unclamped(s.y, p_.grid.origin_y, p_.grid),
              z = grid_coordinate_unclamped(s.z, p_.grid.origin_z, p_.grid);
  for (uint layer = first_layer(y, p_.grid.cells_y); layer < p_.grid.cells_y; ++layer) {
    const CellRange row_x = cells_on_way(x, y, slope_of(v.sun.x, v), float(layer), p_.grid.cells_x);
    const CellRange row_z = cells_on_way(z, y, slope_of(v.sun.z, v), float(layer), p_.grid.cells_z);
    for (uint z_cell = row_z.low; z_cell <= row_z.high; ++z_cell) {
      const uint row = dense_slot(0, layer, z_cell, p_.grid);
      for (uint k = begin_[row + row_x.low]; k < begin_[row + row_x.high + 1]; ++k)
        if (id_[k] != s.sphere && shades(spheres_[id_[k]], s, v)) return true;
    }
  }
  return false;
}

uint CpuLight::colour(uvec2 seen, uint pixel, std::span<const uint> contacts, const View& v) const {
  const Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  const bool sphere = seen.y != ~0u;
  const float ground = v.lighting & LIGHT_GROUND ? depth_of_ground(ray, p_.motion.plane, v) : 0;
  if (!sphere && ground == 0) return lit(v.background, 1);
  const auto sun_of = [&](const Surface& s) { return v.lighting & LIGHT_SHADOW && in_shadow(s, v) ? 0.0f : 1.0f; };
  const auto around_of = [&](const Surface& s) { return v.lighting & LIGHT_OCCLUSION ? around(s) : 1.0f; };
  if (!sphere || (ground > 0 && ground < bits_float(seen.y))) {
    const Surface s = ground_at(ray, ground, p_.motion.plane, v);
    return ground_colour(around_of(s), sun_of(s), v);
  }
  const Normal normal = normal_at(in_camera(spheres_[seen.x], v), ray, bits_float(seen.y));
  const Surface s = surface_of(spheres_[seen.x], seen.x, normal, v);
  return lit(palette(contacts[seen.x], v), light_on_normal(normal, around_of(s), sun_of(s), v));
}

}  // namespace spherepair
