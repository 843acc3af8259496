// SPDX-License-Identifier: MIT
// Near pairs: the colliding pairs of other spheres than the scene's, for what then tests them by itself. A search with
// buffers and parameters of its own.
#pragma once

#include "common/simulation/search/pair_search.h"

namespace spherepair {

class NearPairs {
 public:
  explicit NearPairs(Device& device) : context_(device), sorter_(context_), search_(context_, sorter_) {}

  void plan(const Scene& spheres);    // for spheres like these, and as many
  void moved() { context_.moved(); }  // by a step: the cells watch how far spheres may have gone
  void release() { context_.buffers.share(SLOT_POSITION, {}); }  // the spheres of the last list
  void forget() { context_.buffers.forget(); }                   // frees all
  void check_guards() { context_.buffers.check_guards(); }

  // Of vec4[n] with the radii in w. The list before is overwritten.
  PairList list(const Memory& spheres, const CollideOptions& options = {.method = Method::automatic});

 private:
  DeviceContext context_;
  CellSorter sorter_;
  PairSearch search_;
};

}  // namespace spherepair
