// SPDX-License-Identifier: MIT
#include "glsl/context.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>

#include "common/backend/device_name.h"
#include "common/backend/window_context.h"

namespace spherepair {
namespace {

// libepoxy's own wrappers abort before a display exists, so these come from EGL itself.
template <typename Function>
Function egl_function(const char* name) {
  if (!eglGetProcAddress)
    throw BackendError("opengl: libepoxy.so.0 is missing, or older than 1.5; install libepoxy0 (Fedora: libepoxy)");
  const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (!function)
    throw BackendError(fmt::format(
        "opengl: EGL here has no {}; install libegl1 and a driver for it (libegl-mesa0 for software)", name));
  return function;
}

std::vector<EGLDeviceEXT> egl_devices() {
  const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!query(0, nullptr, &count) || count == 0) {
    throw BackendError(
        "opengl: EGL finds no device; install the GPU's driver, or libegl-mesa0 and libgl1-mesa-dri for software");
  }
  std::vector<EGLDeviceEXT> devices(count);
  query(count, devices.data(), &count);
  devices.resize(count);
  return devices;
}

bool is_software(EGLDeviceEXT device) {
  const auto query = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const char* extensions = query(device, EGL_EXTENSIONS);
  return extensions && std::strstr(extensions, "EGL_MESA_device_software");
}

bool renders_in_software() {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
}

// NVIDIA's driver numbers its devices as CUDA does; others come last.
EGLAttrib cuda_number(EGLDeviceEXT device) {
  const auto query = egl_function<PFNEGLQUERYDEVICEATTRIBEXTPROC>("eglQueryDeviceAttribEXT");
  EGLAttrib number = 0;
  return query(device, EGL_CUDA_DEVICE_NV, &number) ? number : std::numeric_limits<EGLAttrib>::max();
}

std::vector<EGLDeviceEXT> egl_devices_in_order() {
  std::vector<EGLDeviceEXT> devices = egl_devices();
  std::ranges::stable_sort(devices, {}, [](EGLDeviceEXT device) {
    return std::pair(is_software(device), is_software(device) ? 0 : cuda_number(device));
  });
  return devices;
}

thread_local const Context* current_context = nullptr;

// Contexts that the driver has reset. The driver reports a reset once; later reads from the context are wrong. Never
// destroyed, since contexts may live until the process ends.
std::set<EGLContext>& lost_contexts() {
  static auto* contexts = new std::set<EGLContext>;
  return *contexts;
}

}  // namespace

Context::Context(const OpenOptions& options) : window_(options.window) {
  window_ ? make_current() : open_on_a_device(options);
  software_ = renders_in_software();
  if (window_ && software_ && options.require_hardware)
    throw BackendError("opengl: hardware was requested, but the window is drawn in software");
}

void Context::open_on_a_device(const OpenOptions& options) {
  const DeviceName wanted(options.gl_device);
  uint number = 0;
  std::string found, software;
  for (EGLDeviceEXT device : egl_devices_in_order()) {
    if (!options.allow_gpu && !is_software(device)) continue;
    if (!open_on(device)) continue;
    software_ = renders_in_software();
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER)), uuid = device_uuid();
    const bool named = wanted.number ? number == *wanted.number : wanted.uuid == uuid;
    if ((wanted.empty() || named) && !(software_ && options.require_hardware)) return;
    if (software_) software = renderer;
    found += fmt::format("{}{} ({}{})", number ? ", " : "", number, renderer, uuid.empty() ? "" : ", " + uuid);
    ++number;
    close();
  }
  if (!wanted.empty() && !found.empty())
    throw BackendError(
        fmt::format("opengl: there is no OpenGL device {}; the devices are {}", options.gl_device, found));
  if (!software.empty())
    throw BackendError(
        fmt::format("opengl: no GPU, only the software renderer {}; check that the vendor's EGL file is in "
                    "/usr/share/glvnd/egl_vendor.d",
                    software));
  throw BackendError("opengl: no EGL device gives an OpenGL 4.5 core context; update the driver");
}

void Context::close() {
  leave();
  if (context_ == EGL_NO_CONTEXT) return;
  lost_contexts().erase(context_);
  eglDestroyContext(display_, context_);
  context_ = EGL_NO_CONTEXT;
}

bool Context::open_on(EGLDeviceEXT device) {
  const auto get_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const EGLDisplay display = get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
      !epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) {
    return false;
  }
  eglBindAPI(EGL_OPENGL_API);
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_ROBUST_ACCESS,
                               EGL_FALSE,
                               EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                               EGL_LOSE_CONTEXT_ON_RESET,
                               EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return false;
  display_ = display;
  context_ = context;
  make_current();
  return true;
}

Context::~Context() { close(); }

bool Context::try_make_current() const {
  if (window_) window_->make_current();
  bool current = window_ || eglGetCurrentContext() == context_;
  if (!current) {
    before_ = {eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW), eglGetCurrentSurface(EGL_READ),
               eglGetCurrentContext()};
    current = eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  current_context = current ? this : nullptr;
  return current;
}

void Context::leave() const noexcept {
  if (current_context == this) current_context = nullptr;
  if (window_ || context_ == EGL_NO_CONTEXT || eglGetCurrentContext() != context_) return;
  const auto& [display, draw, read, context] = before_;
  if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, draw, read, context)) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool context_is_current() { return current_context != nullptr; }

void Context::make_current() const {
  if (!try_make_current()) {
    throw BackendError(fmt::format("opengl: eglMakeCurrent failed with error 0x{:x}", eglGetError()));
  }
}

std::string device_uuid() {
  if (renders_in_software() || !epoxy_has_gl_extension("GL_EXT_memory_object")) return {};
  GLubyte bytes[GL_UUID_SIZE_EXT] = {};
  glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, bytes);
  std::string uuid;
  for (const GLubyte byte : bytes) uuid += fmt::format("{:02x}", byte);
  return uuid;
}

void gl_check(const std::string& what) {
  const EGLContext current = eglGetCurrentContext();
  if (glGetGraphicsResetStatus() != GL_NO_ERROR) lost_contexts().insert(current);
  if (lost_contexts().contains(current)) {
    throw BackendError(
        fmt::format("opengl: {} failed: the driver reset the context, as it does when a dispatch runs too long; "
                    "use fewer spheres or another method",
                    what));
  }
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  const char* name = error == GL_OUT_OF_MEMORY       ? "out of memory"
                     : error == GL_INVALID_VALUE     ? "invalid value"
                     : error == GL_INVALID_OPERATION ? "invalid operation"
                     : error == GL_INVALID_ENUM      ? "invalid enum"
                                                     : "unknown error";
  throw BackendError(fmt::format("opengl: {} failed: {} (0x{:x})", what, name, error));
}

}  // namespace spherepair
