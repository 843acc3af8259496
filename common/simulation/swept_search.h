// SPDX-License-Identifier: MIT
// Lists the near pairs of a swept search: pairs whose paths within the next step are near each other (swept.h).
#pragma once

#include "common/simulation/motion/device_motion.h"
#include "common/simulation/search/near_pairs.h"

namespace spherepair {

class SweptSearch {
 public:
  SweptSearch(DeviceContext& context, DeviceMotion& motion)
      : context_(context), motion_(motion), near_(context.device) {}

  void upload() { near_.forget(); }  // frees the buffers of another scene's search
  void check_guards() { near_.check_guards(); }

  // Lists these pairs in SLOT_NEAR, DeviceContext::near_pairs of them, and writes the initial velocities of the paths
  // to SLOT_GROWN. Previous near pairs are lost, even if this throws.
  void list_paths(const CollideOptions& options);

 private:
  void list_of(const Scene& grown, const CollideOptions& options);

  DeviceContext& context_;
  DeviceMotion& motion_;
  NearPairs near_;  // pairs of the spheres around the paths
};

}  // namespace spherepair
