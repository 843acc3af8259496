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
  uint taken = 0;
  DenseLevel l = lowest_level(p_.grid);
  for (uint level = 0; level <= p_.grid.top_level; ++level, l = level_above(l)) {
    if ((p_.grid.levels >> level & 1) == 0) continue;
    const CellBox box = box_around(position_in_level(s, l, p_.grid), l);
    for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
      for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
        const uint row = slot_in_level(0, y_cell, z_cell, l);
        for (uint k = begin_[row + box.x.low]; k < begin_[row + box.x.high + 1]; ++k)
          if (id_[k] != s.sphere) taken += taken_by(spheres_[id_[k]], s, p_.grid);
      }
  }
  return light_left(taken);
}

bool CpuLight::any_shades(const CellBox& box, const DenseLevel& l, const Surface& s, const View& v) const {
  for (uint z_cell = box.z.low; z_cell <= box.z.high; ++z_cell)
    for (uint y_cell = box.y.low; y_cell <= box.y.high; ++y_cell) {
      const uint row = slot_in_level(0, y_cell, z_cell, l);
      for (uint k = begin_[row + box.x.low]; k < begin_[row + box.x.high + 1]; ++k)
        if (id_[k] != s.sphere && shades(spheres_[id_[k]], s, v)) return true;
    }
  return false;
}

bool CpuLight::in_shadow(const Surface& s, const View& v) const {
  DenseLevel l = lowest_level(p_.grid);
  for (uint level = 0; level <= p_.grid.top_level; ++level, l = level_above(l)) {
    if ((p_.grid.levels >> level & 1) == 0) continue;
    const GridPosition at = position_in_level(s, l, p_.grid);
    const SunWay way = way_to_sun(at, l, v);
    for (uint k = way.first; k < way.layers; ++k)
      if (any_shades(box_on_way(way, k, at, l), l, s, v)) return true;
  }
  return false;
}

uint CpuLight::colour(uvec2 seen, uint pixel, std::span<const uint> contacts, const View& v) const {
  const Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
  const bool sphere = seen.y != ~0u && (v.lighting & LIGHT_ALONE) == 0;
  const float ground = v.lighting & LIGHT_GROUND ? depth_of_ground(ray, v) : 0;
  if (!sphere && ground == 0) return lit(v.background, 1);
  const auto sun_of = [&](const Surface& s) { return v.lighting & LIGHT_SHADOW && in_shadow(s, v) ? 0.0f : 1.0f; };
  const auto around_of = [&](const Surface& s) { return v.lighting & LIGHT_OCCLUSION ? around(s) : 1.0f; };
  if (!sphere || (ground > 0 && ground < bits_float(seen.y))) {
    const Surface s = ground_at(ray, ground, v);
    return ground_colour(around_of(s), sun_of(s), v);
  }
  const Normal normal = normal_at(in_camera(spheres_[seen.x], v), ray, bits_float(seen.y));
  const Surface s = surface_of(spheres_[seen.x], seen.x, normal, v);
  return lit(palette(contacts[seen.x], v), light_on_normal(normal, around_of(s), sun_of(s), v));
}

}  // namespace spherepair
