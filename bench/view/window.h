// SPDX-License-Identifier: MIT
// A window that shows images and a panel of texts and choices. The panel is rebuilt in every frame, between next() and
// show().
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/shared/layout.h"

namespace spherepair {

class Window {
 public:
  virtual ~Window() = default;

  virtual bool next() = 0;  // processes input since the last frame; false if the user closed the window
  virtual std::array<uint, 2> size() const = 0;       // pixels
  virtual std::array<double, 2> dragged() const = 0;  // by the left button since the last frame, pixels
  virtual double scrolled() const = 0;                // notches, away from the user
  virtual bool pressed(char key) const = 0;           // a lower-case letter or a space

  virtual void text(const std::string& line) = 0;
  virtual bool button(const char* label) = 0;
  virtual void check(const char* label, bool& value) = 0;
  virtual void choose(const char* label, const std::vector<std::string>& names, size_t& chosen) = 0;

  virtual void show(std::span<const uint> image, uint width, uint height) = 0;  // in the format of Backend::image()
  virtual std::vector<uint> screenshot() = 0;                                   // the last shown frame, same format
};

// Throws BackendError, which suggests `render`, without a display or in a build without windows.
std::unique_ptr<Window> open_window(const std::string& title, uint width, uint height);

}  // namespace spherepair
