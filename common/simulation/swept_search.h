// SPDX-License-Identifier: MIT
// What a swept search needs: the pairs whose paths within the next step are near each other (swept.h).
#pragma once

#include "common/simulation/motion/device_motion.h"
#include "common/simulation/search/near_pairs.h"

namespace spherepair {

class SweptSearch {
 public:
  SweptSearch(DeviceContext& context, DeviceMotion& motion)
      : context_(context), motion_(motion), near_(context.device) {}

  void upload() { near_.forget(); }  // what was searched for another scene
  void check_guards() { near_.check_guards(); }

  // Leaves those pairs in SLOT_NEAR, DeviceContext::near_pairs of them, and in SLOT_GROWN the velocities with which the
  // paths begin. Near pairs of others are lost, also where it throws.
  void list_paths(const CollideOptions& options);

 private:
  void list_of(const Scene& grown, const CollideOptions& options);

  DeviceContext& context_;
  DeviceMotion& motion_;
  NearPairs near_;  // of spheres around the paths
};

}  // namespace spherepair
