// SPDX-License-Identifier: MIT
// libepoxy for the shared library, which loads where libepoxy is missing: OpenGL alone then cannot be opened. Defines
// libepoxy's variables that the library uses (epoxy_names.inc, made by the build) and copies their values, functions
// that find OpenGL's or EGL's at their first call.
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace {

bool is_missing = false;

void* symbol(const char* name) {
  static void* const library = dlopen("libepoxy.so.0", RTLD_LAZY | RTLD_LOCAL);
  void* const found = library ? dlsym(library, name) : nullptr;
  is_missing |= !found;
  return found;
}

template <typename Function>
Function value_of(const char* name) {
  void* const variable = symbol(name);
  return variable ? *static_cast<Function*>(variable) : nullptr;
}

}  // namespace

#define LATE(name) decltype(name) name = value_of<decltype(name)>(#name);
#include <epoxy_names.inc>

// The functions that libepoxy has besides.
#define FUNCTION(name) static const auto late_##name = reinterpret_cast<decltype(&name)>(symbol(#name));
FUNCTION(epoxy_gl_version)
FUNCTION(epoxy_has_gl_extension)
FUNCTION(epoxy_has_egl_extension)
int epoxy_gl_version() { return late_epoxy_gl_version(); }
bool epoxy_has_gl_extension(const char* name) { return late_epoxy_has_gl_extension(name); }
bool epoxy_has_egl_extension(EGLDisplay display, const char* name) {
  return late_epoxy_has_egl_extension(display, name);
}

// A library that lacks one of them is as good as none: opening OpenGL then says so.
static const bool is_ready = [] {
  if (is_missing) epoxy_eglGetProcAddress = nullptr;
  return !is_missing;
}();
