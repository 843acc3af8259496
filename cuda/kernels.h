// SPDX-License-Identifier: MIT
// What every kernel gets, and where the host finds the kernels: one entry per file, by group size and variant.
#pragma once

#include "layout.h"

namespace spherepair {

// The buffers of layout.h, by slot.
struct World {
  vec4* position;
  vec4* velocity;
  uint* count;
  uint* summary;
  uvec2* deferred;
  uvec2* listed;
  const vec4* spheres;
  uint* verdict;
};

// Every kernel is void (Params p, World w). A null entry means a group size that was not compiled.
using Entry = const void*;
Entry move_kernel();
Entry clear_kernel();
Entry empty_kernel();
Entry settle_kernel();
Entry decide_kernel();
Entry collide_group_kernel(uint block, bool equal_radii);
Entry collide_tiled_kernel(uint block, bool equal_radii);
Entry collide_square_kernel(uint block, bool equal_radii);
Entry collide_triangle_kernel(uint block, bool equal_radii);

}  // namespace spherepair
