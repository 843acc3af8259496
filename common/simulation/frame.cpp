// SPDX-License-Identifier: MIT
#include "common/simulation/frame.h"

namespace spherepair {
namespace {

constexpr uint tile_groups = 1024;  // that fill a large device

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
  context.device.read(SLOT_DRAWN, &frame.tiles_of_depth_pass, DRAWN_TILES * sizeof(uint), sizeof(uint));
  context.device.write(SLOT_DRAWN, none, DRAWN_TILES * sizeof(uint), sizeof(none));
}

}  // namespace spherepair
