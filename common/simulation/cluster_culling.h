// SPDX-License-Identifier: MIT
// Two-pass occlusion culling of clusters. It draws the spheres visible in the last images first, makes a depth pyramid
// of them, then draws the rest that the pyramid does not hide. Where the camera moved, gaps open between the spheres
// drawn first. For many spheres the near clusters fill these gaps before the far ones are tested.
#pragma once

#include <vector>

#include "common/simulation/frame.h"
#include "common/simulation/search/cell_sorter.h"

namespace spherepair {

class ClusterCulling {
 public:
  ClusterCulling(DeviceContext& context, const CellSorter& sorter) : context_(context), sorter_(sorter) {}

  void upload();
  void forget_visible() { visible_known_ = false; }  // call when the last image's pixels are lost

  // Prepares the list of the spheres in the last image's pixels, before these are cleared. A new scene's list is empty.
  void prepare_list();
  uint turn() const { return turn_; }  // for View::turn of the next image
  void end_image() { turn_ = 1 - turn_; }

  // Draws all phases. by_cells: use the borders of cells as the clusters' boxes.
  void draw(Frame& frame, bool by_cells);

 private:
  void make_boxes(const Frame& frame, bool by_cells);
  std::vector<uint> phases_of(const Frame& frame, bool per_sphere) const;
  void draw_phase(Frame& frame, uint phase);
  void cull(Frame& frame, uint phase);
  bool eye_among_cells(const Frame& frame) const;

  DeviceContext& context_;
  const CellSorter& sorter_;
  std::optional<Order> boxes_of_;  // order whose clusters have boxes ...
  uint64_t boxes_version_ = 0;     // ... at this version of the spheres
  bool visible_known_ = false;     // SLOT_VISIBLE, or the list from it, is of this scene
  uint turn_ = 0;
};

}  // namespace spherepair
