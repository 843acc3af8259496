// SPDX-License-Identifier: MIT
// The light of a image on the CPU: the reference of the kernel draw_light.
#pragma once

#include <span>
#include <vector>

#include "common/shared/light.h"

namespace spherepair {

// The spheres in the dense cells, level by level, that p describes, whatever the order within a cell.
class CpuLight {
 public:
  CpuLight(std::span<const vec4> spheres, const Params& p);
  float around(const Surface& s) const;  // the share of the light from all around that arrives
  bool in_shadow(const Surface& s, const View& v) const;
  uint colour(uvec2 seen, uint pixel, std::span<const uint> contacts, const View& v) const;

 private:
  bool any_shades(const CellBox& box, const DenseLevel& l, const Surface& s, const View& v) const;

  std::span<const vec4> spheres_;
  Params p_;
  std::vector<uint> begin_, id_;  // of each cell; by sorted index
};

}  // namespace spherepair
