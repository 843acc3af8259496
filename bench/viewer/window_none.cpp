// SPDX-License-Identifier: MIT
// Replaces window_glfw.cpp in a build without GLFW or Dear ImGui, or with static tools.
#include "bench/viewer/window.h"
#include "common/backend/backend.h"

namespace spherepair {

std::unique_ptr<Window> open_window(const std::string&, uint, uint, bool) {
  throw BackendError(
      "this program was built without windows: install libglfw3-dev and libimgui-dev, configure without "
      "SPHEREPAIR_STATIC_TOOLS and build again; `spherepair render` draws to files");
}

}  // namespace spherepair
