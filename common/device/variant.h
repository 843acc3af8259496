// SPDX-License-Identifier: MIT
// The variants for which kernels of collisions and of motion are compiled; a kernel ignores fields that it lacks.
#pragma once

#include <compare>

#include "common/scene/motion_options.h"
#include "common/shared/layout.h"

namespace spherepair {

struct Variant {
  bool equal_radii = true;     // loads no radius
  bool listed = false;         // keeps the pairs, not only their number
  bool texture_table = false;  // GLSL: reads the table of cells or the pyramid through a buffer texture
  bool dense = false;          // grid_bounds and sorting kernels: cells are dense
  bool from_tiles = false;     // grid_sort: reads the spheres from split_tiles
  bool bundles = false;        // draw_cull, draw_clusters: test bundles of clusters first
  bool by_cells = false;       // draw_bounds: spheres are in the order of dense cells, whose borders bound clusters
  bool long_rows = false;      // list_count: groups write the keys of a row together
  uint indices = 0;            // INDEX_*, if the spheres are in cell order; CUDA takes it at run time
  bool folded = false;         // GLSL: groups are numbered along two axes, or not from 0
  bool windows = false;        // GLSL: the table is in several textures, one of which a dispatch reads
  MotionOptions motion = {};   // for move, bounce and evaluate_positions
  auto operator<=>(const Variant&) const = default;
};

}  // namespace spherepair
