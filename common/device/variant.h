// SPDX-License-Identifier: MIT
// What the kernels of collisions and of motion are compiled for; a kernel without a choice of variants ignores it.
#pragma once

#include <compare>

#include "common/scene/motion_options.h"
#include "common/shared/layout.h"

namespace spherepair {

struct Variant {
  bool equal_radii = true;     // loads no radius
  bool listed = false;         // keeps the pairs, not only their number
  bool texture_table = false;  // GLSL: the table of cells or the pyramid is read through a buffer texture
  bool dense = false;          // grid_bounds and what sorts: the cells are
  bool from_tiles = false;     // grid_sort: the spheres come from split_tiles
  bool bundles = false;        // draw_cull, draw_clusters: bundles of clusters are tested first
  bool by_cells = false;       // draw_bounds: spheres stand in the order of dense cells, whose borders hold clusters
  uint indices = 0;            // INDEX_*, where the spheres come in cell order; CUDA takes it at run time
  bool folded = false;         // GLSL: groups are numbered along two axes, or not from 0 on
  bool windows = false;        // GLSL: that table in several textures, of which a dispatch reads one
  bool float_sums = false;     // contact_pairs, leapfrog: impulses are summed in float32, in any order
  MotionOptions motion = {};   // of move, bounce and evaluate_positions
  auto operator<=>(const Variant&) const = default;
};

}  // namespace spherepair
