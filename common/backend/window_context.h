// SPDX-License-Identifier: MIT
#pragma once

namespace spherepair {

// A window's OpenGL 4.5 core context. Everything that draws can use it, so that images stay on the GPU.
class WindowContext {
 public:
  virtual ~WindowContext() = default;
  virtual void make_current() = 0;  // does nothing if it is current already
};

}  // namespace spherepair
