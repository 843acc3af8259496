// SPDX-License-Identifier: MIT
#include "common/simulation/search/near_pairs.h"

#include <utility>

namespace spherepair {

void NearPairs::plan(const Scene& grown) {
  radius_ = common_radius(grown);
  equal_radii_ = grown.equal_radii;
  sorter_.upload(grown);
  search_.upload(grown);
  context_.buffers.resize(SLOT_NEAR, context_.buffers.bytes(SLOT_PAIR));
}

// The grown spheres stand in for the scene's until their pairs are listed.
void NearPairs::list(const CollideOptions& options) {
  sorter_.replaced();
  search_.moved(false);
  float radius = radius_;
  bool equal = equal_radii_;
  const auto exchange = [&] {
    context_.buffers.swap(SLOT_POSITION, SLOT_GROWN);
    std::swap(context_.params.radius, radius);
    std::swap(context_.equal_radii, equal);
  };
  exchange();
  try {
    context_.near_pairs = uint(search_.list_pairs(options));
  } catch (...) {
    exchange();
    throw;
  }
  exchange();
  context_.buffers.swap(SLOT_PAIR, SLOT_NEAR);
}

}  // namespace spherepair
