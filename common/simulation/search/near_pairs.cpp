// SPDX-License-Identifier: MIT
#include "common/simulation/search/near_pairs.h"

namespace spherepair {

void NearPairs::plan(const Scene& spheres) {
  context_.set_spheres(spheres);
  sorter_.upload(spheres);
  search_.upload(spheres);
}

PairList NearPairs::list(const Memory& spheres, uint64_t n, const CollideOptions& options) {
  context_.n = n;
  context_.params.n = uint(n);
  if (n > context_.room) {
    context_.room = n + n / 16;
    search_.make_room();
  }
  context_.moved();  // they are others than those of the last list, also within one step
  context_.buffers.share(SLOT_POSITION, spheres);
  const auto count = uint(search_.list_pairs(options));
  return {context_.buffers.memory(SLOT_PAIR), count};
}

}  // namespace spherepair
