// SPDX-License-Identifier: MIT
// A window that shows images and a panel of texts. The panel is rebuilt in every frame.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/backend/window_context.h"
#include "common/shared/layout.h"

namespace spherepair {

enum class Present {
  never,       // for timing without the display system
  at_refresh,  // as often as the display refreshes; frames in between are not seen
  and_wait     // the same, and waits, so that there are no frames in between
};

constexpr char escape_key = '\x1b';

class Window {
 public:
  virtual ~Window() = default;

  // Presents the image of show() and processes new input; false if the user has closed the window.
  virtual bool next(Present present) = 0;
  virtual double seconds() const = 0;                 // on a clock that never goes back
  virtual std::array<uint, 2> size() const = 0;       // pixels
  virtual std::array<double, 2> dragged() const = 0;  // by the left button since the last frame, pixels
  virtual std::array<double, 2> panned() const = 0;   // by another one, or with shift
  virtual double scrolled() const = 0;                // notches, away from the user
  virtual bool pressed(char key) const = 0;           // a lower-case letter, a space, + (also =), - or escape_key

  // The panel: call these between next() and show().
  virtual void begin_panel(const std::string& title) = 0;
  virtual void end_panel() = 0;
  virtual void text(const std::string& line) = 0;  // wrapped
  // Squares of these colours, 0xRRGGBB, each with its label.
  virtual void legend(std::span<const uint> colours, const std::vector<std::string>& labels) = 0;

  // The image for the next show(): a texture of this size for Drawing::show(), or an uploaded image in the format of
  // Drawing::image().
  virtual uint texture(uint width, uint height) = 0;
  virtual void upload(std::span<const uint> image) = 0;  // of the last texture()'s size
  virtual void show() = 0;
  virtual std::vector<uint> screenshot() = 0;  // the last shown frame, same format

  virtual WindowContext& context() = 0;
  virtual std::string renderer() const = 0;  // of its OpenGL context
};

// shared: the window has a context for all that draws (WindowContext); else one that can coexist with EGL's contexts.
// Throws BackendError, which suggests `render`, without a display or in a build without windows.
std::unique_ptr<Window> open_window(const std::string& title, uint width, uint height, bool shared);

}  // namespace spherepair
