// SPDX-License-Identifier: MIT
// A headless OpenGL 4.5 core context through EGL. The display is the process's; the context belongs to this object.
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "common/backend/backend.h"

namespace spherepair {

class Context {
 public:
  // Takes the first EGL device that gives GL 4.5, hardware before software.
  explicit Context(const OpenOptions& options);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void make_current() const;
  bool try_make_current() const;  // false when the context is lost
  bool software() const { return software_; }

 private:
  bool open_on(EGLDeviceEXT device);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  bool software_ = false;
};

// Throws BackendError with the name of GL's pending error, if there is one.
void gl_check(const std::string& what);

}  // namespace spherepair
