// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context: a headless one through EGL, which belongs to this object, or a window's.
#pragma once

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "common/backend/backend.h"

namespace spherepair {

class Context {
 public:
  // Opens the GPU that options.gl_device names, else the first in this order: hardware before software, GPUs in CUDA's
  // order where the driver tells it. Counts only EGL devices that offer GL 4.5.
  explicit Context(const OpenOptions& options);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void make_current() const;
  bool try_make_current() const;  // false when the context is lost
  void leave() const noexcept;    // makes the thread's earlier context current again, or none
  bool software() const { return software_; }
  bool of_window() const { return window_ != nullptr; }

 private:
  void open_on_a_device(const OpenOptions& options);
  bool open_on(EGLDeviceEXT device);
  void close();

  WindowContext* window_ = nullptr;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  struct Before {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLSurface draw = EGL_NO_SURFACE, read = EGL_NO_SURFACE;
    EGLContext context = EGL_NO_CONTEXT;
  };
  mutable Before before_;
  bool software_ = false;
};

// Whether a context is current. If not, it was lost together with its objects.
bool context_is_current();

// The UUID of the current context's GPU, 32 hex digits; empty for software.
std::string device_uuid();

// Throws BackendError with the name of GL's pending error, if there is one.
void gl_check(const std::string& what);

}  // namespace spherepair
