// SPDX-License-Identifier: MIT
// One image in the rasteriser: the data that all its launches share.
#pragma once

#include "common/device/context.h"
#include "common/plan/grid_plan.h"

namespace spherepair {

struct Frame {
  View view;  // phase and pass change from launch to launch
  DrawOptions options;
  Order order = Order::scene;        // of the spheres
  uint indices = 0;                  // Variant::indices for this order
  uint visible_slot = SLOT_VISIBLE;  // its pixels
  Slots unused = 0;                  // buffers that draw_spheres does not use
  bool culls = false;                // culls clusters
  bool may_have_tiles = true;        // a sphere may look large
  uint tiles_of_depth_pass = 0;      // if depths and indices need a pass each
};

inline uint64_t pixels(const View& view) { return uint64_t(view.width) * view.height; }

// Whether any sphere's box of pixels may be large (is_large), for spheres as they were when these cells were planned.
bool may_look_large(const View& view, const GridPlan& dense);

// Returns the launch with the frame's view and pixels.
Launch drawing(const Frame& frame, Launch launch);
void launch_drawing(DeviceContext& context, const Frame& frame, const Launch& launch);

// Draws the large spheres listed so far, tile by tile.
void launch_tiles(DeviceContext& context, const Frame& frame);

// Empties the list of tiles before the index pass, which lists them again: fewer, if more spheres are drawn by then.
void restart_tiles(DeviceContext& context, Frame& frame);

}  // namespace spherepair
