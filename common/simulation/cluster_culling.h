// SPDX-License-Identifier: MIT
// Two-pass occlusion culling of clusters: the spheres that the last images showed are drawn first, a depth pyramid is
// made of them, and of the rest only what that does not hide is drawn. Where the camera moved, gaps open between the
// spheres drawn first; of many spheres the near clusters fill them before the far ones are tested.
#pragma once

#include <vector>

#include "common/simulation/frame.h"
#include "common/simulation/search/cell_sorter.h"

namespace spherepair {

class ClusterCulling {
 public:
  ClusterCulling(DeviceContext& context, const CellSorter& sorter) : context_(context), sorter_(sorter) {}

  void upload();
  void forget_visible() { visible_known_ = false; }  // the pixels of the last image are gone

  // Before the pixels of the last image are cleared: the list of the spheres that they show. All of it is empty for a
  // new scene.
  void prepare_list();
  uint turn() const { return turn_; }  // View::turn of the next image
  void end_image() { turn_ = 1 - turn_; }

  // by_cells: the borders of the cells are the boxes of the clusters.
  void draw(Frame& frame, bool by_cells);

 private:
  void make_boxes(const Frame& frame, bool by_cells);
  std::vector<uint> phases_of(const Frame& frame, bool per_sphere) const;
  void draw_phase(Frame& frame, uint phase);
  void cull(Frame& frame, uint phase);
  bool eye_among_cells(const Frame& frame) const;

  DeviceContext& context_;
  const CellSorter& sorter_;
  std::optional<Order> boxes_of_;  // the order whose clusters have boxes ...
  uint64_t boxes_version_ = 0;     // ... of the spheres as they were then
  bool visible_known_ = false;     // SLOT_VISIBLE, or the list made of it, has spheres of this scene
  uint turn_ = 0;
};

}  // namespace spherepair
