// SPDX-License-Identifier: MIT
// One image on its way through the rasteriser: what every launch of it has in common.
#pragma once

#include "common/backend/grid_plan.h"
#include "common/device/context.h"

namespace spherepair {

struct Frame {
  View view;  // phase and pass change from launch to launch
  DrawOptions options;
  Order order = Order::scene;        // of the spheres
  uint indices = 0;                  // Variant::indices of that
  uint visible_slot = SLOT_VISIBLE;  // its pixels
  Slots unused = 0;                  // by draw_spheres
  bool culls = false;                // by clusters
  bool may_have_tiles = true;        // some sphere may look large
  uint tiles_of_depth_pass = 0;      // where depths and indices take a pass each
};

inline uint64_t pixels(const View& view) { return uint64_t(view.width) * view.height; }

// Whether any sphere's box of pixels may be large (is_large), of spheres as they were when these dense cells were
// planned.
bool may_look_large(const View& view, const GridPlan& dense);

// The launch with the frame's view and pixels.
Launch drawing(const Frame& frame, Launch launch);
void launch_drawing(DeviceContext& context, const Frame& frame, const Launch& launch);

// The large spheres listed so far, tile by tile.
void launch_tiles(DeviceContext& context, const Frame& frame);

// Before the pass of the indices, which lists the tiles again, of fewer spheres where more is drawn by then.
void restart_tiles(DeviceContext& context, Frame& frame);

}  // namespace spherepair
