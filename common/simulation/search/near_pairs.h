// SPDX-License-Identifier: MIT
// Lists near pairs: the colliding pairs of other spheres than the scene's, which other kernels then test. It is a
// search with its own buffers and parameters.
#pragma once

#include "common/simulation/search/pair_search.h"

namespace spherepair {

class NearPairs {
 public:
  explicit NearPairs(Device& device) : context_(device), sorter_(context_), search_(context_, sorter_) {}

  void plan(const Scene& spheres);    // plans cells for spheres like these
  void moved() { context_.moved(); }  // after a step: the cells watch how far spheres may have moved
  void release() { context_.buffers.share(SLOT_POSITION, {}); }  // gives up the last list's spheres
  void forget() { context_.buffers.forget(); }                   // frees all buffers
  void check_guards() { context_.buffers.check_guards(); }

  // Lists pairs of vec4[n] with the radii in w; n need not be that of the plan. Overwrites the previous list.
  PairList list(const Memory& spheres, uint64_t n, const CollideOptions& options = {.method = Method::automatic});

 private:
  DeviceContext context_;
  CellSorter sorter_;
  PairSearch search_;
};

}  // namespace spherepair
