// SPDX-License-Identifier: MIT
#pragma once

namespace spherepair {

// A window's OpenGL 4.5 core context, in which everything that draws can live, so that images stay on the GPU.
class WindowContext {
 public:
  virtual ~WindowContext() = default;
  virtual void make_current() = 0;  // nothing where it is already
};

}  // namespace spherepair
