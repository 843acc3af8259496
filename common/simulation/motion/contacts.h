// SPDX-License-Identifier: MIT
// Contacts that push, on a device: their impulses, and what a step could not do.
#pragma once

#include "common/simulation/motion/context.h"

namespace spherepair {

class Contacts {
 public:
  explicit Contacts(DeviceContext& context) : context_(context) {}

  // The scene's part of the parameters; after the motion's upload, whose method decides what the buffers are for.
  void upload(const Scene& scene);
  bool on() const { return on_; }

  // Launches the impulses of the pairs that the search of these positions has listed; the motion's step takes them.
  void push();

  // Throws std::invalid_argument naming the sphere where a step since the upload was not possible.
  void require_sound();

 private:
  DeviceContext& context_;
  bool on_ = false;
};

}  // namespace spherepair
