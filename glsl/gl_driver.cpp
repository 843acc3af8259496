// SPDX-License-Identifier: MIT
#include "gl_driver.h"

#include <fmt/format.h>

#include <filesystem>

namespace spherepair {
namespace {

std::string gl_string(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

std::string device_uuid() {
  GLubyte bytes[GL_UUID_SIZE_EXT] = {};
  glGetUnsignedBytei_vEXT(GL_DEVICE_UUID_EXT, 0, bytes);
  std::string uuid;
  for (const GLubyte byte : bytes) uuid += fmt::format("{:02x}", byte);
  return uuid;
}

// A group of 1024 must have no more subgroups than one of them has invocations: see group_sum.glsl.
bool has_subgroups() {
  if (!epoxy_has_gl_extension("GL_KHR_shader_subgroup")) return false;
  GLint invocations = 0, kinds = 0;
  glGetIntegerv(GL_SUBGROUP_SIZE_KHR, &invocations);
  glGetIntegerv(GL_SUBGROUP_SUPPORTED_FEATURES_KHR, &kinds);
  return invocations >= 32 && (kinds & GL_SUBGROUP_FEATURE_ARITHMETIC_BIT_KHR) != 0;
}

}  // namespace

void require_gl_features() {
  if (epoxy_gl_version() < 45) {
    throw BackendError(fmt::format("glsl: {} offers OpenGL {}, but 4.5 is needed; update the driver",
                                   gl_string(GL_RENDERER), gl_string(GL_VERSION)));
  }
  if (!epoxy_has_gl_extension("GL_ARB_gpu_shader_int64")) {
    throw BackendError(
        fmt::format("glsl: {} lacks GL_ARB_gpu_shader_int64, which the exact stages need; update the driver",
                    gl_string(GL_RENDERER)));
  }
}

Features driver_features() { return {epoxy_has_gl_extension("GL_NV_shader_atomic_int64"), has_subgroups()}; }

BackendInfo describe_driver(bool software, bool sparse, Features features) {
  GLint64 binding = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &binding);
  GLint shared_bytes = 0;
  glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &shared_bytes);
  BackendInfo info;
  info.name = "glsl";
  info.device = gl_string(GL_RENDERER);
  info.software = software;
  info.device_timers = !software;  // a software renderer's timers stop before its work does
  if (!software && epoxy_has_gl_extension("GL_EXT_memory_object")) info.uuid = device_uuid();
  info.details = {{"GL_RENDERER", gl_string(GL_RENDERER)},
                  {"GL_VENDOR", gl_string(GL_VENDOR)},
                  {"GL_VERSION", gl_string(GL_VERSION)},
                  {"GLSL version", gl_string(GL_SHADING_LANGUAGE_VERSION)},
                  {"largest storage block bytes", std::to_string(binding)},
                  {"shared memory bytes", std::to_string(shared_bytes)},
                  {"64-bit atomics", features.atomics_64 ? "yes" : "no: drawing takes two passes"},
                  {"subgroups", features.subgroups ? "yes" : "no: sums go through shared memory"},
                  {"buffers", sparse ? "sparse storage, committed whole" : "plain storage"}};
  if (info.software && std::filesystem::exists("/dev/nvidiactl")) {
    info.details["warning"] = "a GPU is present, but OpenGL runs in software";
  }
  return info;
}

}  // namespace spherepair
