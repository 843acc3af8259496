// SPDX-License-Identifier: MIT
// The rasteriser on the CPU: the reference for the kernels draw_*.
#pragma once

#include <span>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

struct CpuImage {
  std::vector<uint> image;     // as SLOT_IMAGE
  std::vector<uvec2> visible;  // as SLOT_VISIBLE
  DrawStatistics counts;
};
// Draws the spheres. Only a view with LIGHT_* reads the cells for the light in p.
CpuImage draw_image(std::span<const vec4> spheres, std::span<const uint> contacts, const View& view, const Params& p,
                    int threads);

}  // namespace spherepair
