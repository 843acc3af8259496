// SPDX-License-Identifier: MIT
#include "common/simulation/frame.h"

#include <algorithm>
#include <cmath>

namespace spherepair {
namespace {

constexpr uint tile_groups = 1024;  // enough to fill a large device

const char* tiles_stage(uint phase) {
  constexpr const char* names[] = {"draw_tiles_seen", "draw_tiles_rest", nullptr, "draw_tiles_far", "draw_tiles_rest"};
  return names[phase];
}

}  // namespace

Launch drawing(const Frame& frame, Launch launch) {
  launch.view = &frame.view;
  launch.visible_slot = frame.visible_slot;
  return launch;
}

void launch_drawing(DeviceContext& context, const Frame& frame, const Launch& launch) {
  context.launch(drawing(frame, launch));
}

void launch_tiles(DeviceContext& context, const Frame& frame) {
  if (!frame.may_have_tiles) return;
  Launch tiles{Kernel::draw_tiles, SERVICE_BLOCK, {}, {tile_groups, 1, 1}};
  if (frame.view.occlusion) tiles.stage = tiles_stage(frame.view.phase);
  launch_drawing(context, frame, tiles);
}

void restart_tiles(DeviceContext& context, Frame& frame) {
  const uint none[] = {0, 0};
  context.buffers.read(SLOT_DRAWN, &frame.tiles_of_depth_pass, DRAWN_TILES * sizeof(uint), sizeof(uint));
  context.buffers.write(SLOT_DRAWN, none, DRAWN_TILES * sizeof(uint), sizeof(none));
}

// Bounds the largest sphere's size in pixels. All spheres are in the cells' box, so none looks larger than the largest
// would in the nearest corner, at the image's edge.
bool may_look_large(const View& view, const GridPlan& plan) {
  const double eye[] = {view.eye.x, view.eye.y, view.eye.z};
  const double forward[] = {view.forward.x, view.forward.y, view.forward.z};
  const double radius = plan.largest_radius;
  double close = 0, coordinates = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = plan.origin[axis] - eye[axis], high = low + plan.size[axis] * double(plan.side);
    close += std::min(forward[axis] * low, forward[axis] * high);
    coordinates += std::abs(eye[axis]) + std::max(std::abs(low), std::abs(high));
  }
  close -= coordinates * 0x1p-20;  // more than the rounding of a coordinate
  if (!(close > 1.01 * radius)) return true;
  const double aside = std::max(view.half_x, view.half_y), beyond = std::max(view.norm_x, view.norm_y) * radius;
  const double pixels = 2 * radius * view.focal * ((1 + aside) * close + beyond) / (close * close - radius * radius);
  const uint most = view.lanes == LANES ? SHARE_AT_MOST : WALK_AT_MOST;
  return !(1.01 * pixels + 2 <= most);
}

}  // namespace spherepair
