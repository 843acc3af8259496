// SPDX-License-Identifier: MIT
// Contacts that push, on a device: the list of near pairs, their impulses, and what a step could not do.
#pragma once

#include "common/simulation/pair_search.h"

namespace spherepair {

class Contacts {
 public:
  Contacts(DeviceContext& context, DeviceMotion& motion)
      : context_(context), sorter_(context), search_(context, motion, sorter_) {}

  // The scene's part of the parameters; after the motion's upload, whose method decides what the buffers are for, and
  // after that of the scene's own search.
  void upload(const Scene& scene);
  bool on() const { return on_; }

  void keep_list(bool on) { keeps_ = on; }  // else pairs are listed in every step

  // Makes the list serve these positions: true where it was made anew, by a search in the buffers of the others.
  bool update_list();

  // Launches the impulses of these positions; the motion's step takes them.
  void push();

  // Throws std::invalid_argument naming the sphere where a step since the upload was not possible.
  void require_sound();

 private:
  bool serves();
  void list_near_pairs();

  DeviceContext& context_;
  CellSorter sorter_;  // of the grown spheres, as is the search
  PairSearch search_;
  float grown_radius_ = 0;  // where all are equal
  uint64_t listed_ = 0;     // near pairs
  bool on_ = false, made_ = false, keeps_ = true;
};

}  // namespace spherepair
