// SPDX-License-Identifier: MIT
// A window that shows images and a panel of texts and choices, which is rebuilt in every frame that has one.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/backend/window_context.h"
#include "common/shared/layout.h"

namespace spherepair {

class Window {
 public:
  virtual ~Window() = default;

  // Presents what show() has drawn, as often as the display refreshes, and processes the input since; false if the user
  // has closed the window. present: false: for timing without what the display system takes.
  virtual bool next(bool present = true) = 0;
  virtual std::array<uint, 2> size() const = 0;                    // pixels
  virtual std::array<double, 2> dragged() const = 0;               // by the left button since the last frame, pixels
  virtual double scrolled() const = 0;                             // notches, away from the user
  virtual std::optional<std::array<uint, 2>> clicked() const = 0;  // pixel, from the upper left; not the end of a drag
  virtual bool pressed(char key) const = 0;                        // a lower-case letter or a space

  // The panel: begun and ended between next() and show().
  virtual void begin_panel() = 0;
  virtual void end_panel() = 0;
  virtual void text(const std::string& line) = 0;
  virtual bool button(const char* label) = 0;
  virtual void check(const char* label, bool& value) = 0;
  virtual void slide(const char* label, uint64_t& value, uint64_t low, uint64_t high) = 0;
  // Squares of these colours, 0xRRGGBB, each with its label.
  virtual void legend(std::span<const uint> colours, const std::vector<std::string>& labels) = 0;
  virtual void choose(const char* label, const std::vector<std::string>& names, size_t& chosen) = 0;

  // The image that the next show() shows: a texture of this size for Backend::show(), or uploaded, in the format of
  // Backend::image().
  virtual uint texture(uint width, uint height) = 0;
  virtual void upload(std::span<const uint> image) = 0;  // of the size given last
  virtual void show() = 0;
  virtual std::vector<uint> screenshot() = 0;  // the last shown frame, same format

  virtual WindowContext& context() = 0;
  virtual std::string renderer() const = 0;  // of its context, as OpenGL names it
};

// shared: with a context for everything that draws (WindowContext); else one that contexts of EGL's can exist with.
// Throws BackendError, which suggests `render`, without a display or in a build without windows.
std::unique_ptr<Window> open_window(const std::string& title, uint width, uint height, bool shared);

}  // namespace spherepair
