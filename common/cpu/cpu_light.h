// SPDX-License-Identifier: MIT
// The light of an image on the CPU: the reference for the kernel draw_light.
#pragma once

#include <span>
#include <vector>

#include "common/shared/light.h"

namespace spherepair {

// Holds the spheres in the dense cells that p describes, level by level, in any order within a cell.
class CpuLight {
 public:
  CpuLight(std::span<const vec4> spheres, const Params& p);
  float around(const Surface& s) const;  // share of the light from all around that reaches the surface
  bool in_shadow(const Surface& s, const View& v) const;
  uint colour(uvec2 seen, uint pixel, std::span<const uint> contacts, const View& v) const;

 private:
  bool any_shades(const CellBox& box, const DenseLevel& l, const Surface& s, const View& v) const;

  std::span<const vec4> spheres_;
  Params p_;
  std::vector<uint> begin_, id_;  // first entry of each cell in id_; sphere indices by cell
};

}  // namespace spherepair
