// SPDX-License-Identifier: MIT
// Near pairs: the colliding pairs of grown spheres, for what then tests them by itself.
#pragma once

#include "common/simulation/search/pair_search.h"

namespace spherepair {

class NearPairs {
 public:
  NearPairs(DeviceContext& context, DeviceMotion& motion)
      : context_(context), motion_(motion), sorter_(context), search_(context, motion, sorter_) {}

  // For spheres like these, the grown ones, and as many as the scene's.
  void plan(const Scene& grown);
  void moved() { sorter_.moved(); }

  // Searches the spheres in SLOT_GROWN and leaves DeviceContext::near_pairs of them in SLOT_NEAR. The table of cells
  // and its parameters are those of the grown spheres then, and results of other searches are lost.
  void list(const CollideOptions& options = {.method = Method::automatic});

  // The same of spheres around the paths of the next step (swept.h); SLOT_GROWN then has the velocities with which
  // these begin. Results of other searches, their cells and other near pairs are lost, also where it throws.
  void list_paths(const CollideOptions& options);

 private:
  void list_of(const Scene& grown, const CollideOptions& options);

  DeviceContext& context_;
  DeviceMotion& motion_;
  CellSorter sorter_;  // of the grown spheres, as is the search
  PairSearch search_;
  float radius_ = 0;  // where all are equal
  bool equal_radii_ = true;
};

}  // namespace spherepair
