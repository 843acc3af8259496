// SPDX-License-Identifier: MIT
#include "glsl/device_limits.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "glsl/context.h"

namespace spherepair {
namespace {

std::string gl_string(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

int gl_integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void require_features() {
  if (epoxy_gl_version() < 45) {
    throw BackendError(fmt::format("opengl: {} offers OpenGL {}, but 4.5 is needed; update the driver",
                                   gl_string(GL_RENDERER), gl_string(GL_VERSION)));
  }
  if (!epoxy_has_gl_extension("GL_ARB_gpu_shader_int64")) {
    throw BackendError(
        fmt::format("opengl: {} lacks GL_ARB_gpu_shader_int64, which the exact stages need; update the driver",
                    gl_string(GL_RENDERER)));
  }
}

// Whether subgroups are as group_sum.glsl assumes. A group of 1024 must have no more subgroups than a subgroup has
// invocations. A subgroup's invocations must be consecutive, which no query tells: NVIDIA's are; other GPUs use shared
// memory.
bool has_subgroups() {
  if (!epoxy_has_gl_extension("GL_KHR_shader_subgroup") || !gl_string(GL_VENDOR).starts_with("NVIDIA")) return false;
  GLint invocations = 0, kinds = 0;
  glGetIntegerv(GL_SUBGROUP_SIZE_KHR, &invocations);
  glGetIntegerv(GL_SUBGROUP_SUPPORTED_FEATURES_KHR, &kinds);
  constexpr GLint needed = GL_SUBGROUP_FEATURE_ARITHMETIC_BIT_KHR | GL_SUBGROUP_FEATURE_SHUFFLE_BIT_KHR;
  return invocations >= 32 && (kinds & needed) == needed;
}

std::string out_of_memory(uint64_t bytes_asked) {
  GLint free_kib = -1;
  if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
    glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &free_kib);
  const std::string free =
      free_kib < 0 ? "this driver does not say how many are free" : fmt::format("{} free", uint64_t(free_kib) * 1024);
  return fmt::format("opengl: out of memory: {} bytes asked, {}; use fewer spheres or no pair list", bytes_asked, free);
}

std::string storage_in_words(const DeviceLimits& limits) {
  if (!limits.large_pages) return "plain storage";
  if (DriverMemory::present()) return "memory of the driver, imported, from 2 MiB on";
  return limits.sparse ? "sparse storage, committed whole, from 2 MiB on" : "plain storage";
}

}  // namespace

DeviceLimits device_limits(const OpenOptions& options) {
  require_features();
  if (options.to_spirv && !epoxy_has_gl_extension("GL_ARB_gl_spirv"))
    throw BackendError("opengl-spirv: " + gl_string(GL_RENDERER) + " lacks GL_ARB_gl_spirv; choose opengl");
  const bool vendor = !options.vendor_free;
  GLint64 binding = 0;
  const uint64_t texels = uint64_t(gl_integer(GL_MAX_TEXTURE_BUFFER_SIZE));
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &binding);
  return {.largest_binding = uint64_t(binding),
          .largest_texture = std::min(texels, options.texels),
          .features = {.atomics_64 = vendor && epoxy_has_gl_extension("GL_NV_shader_atomic_int64"),
                       .subgroups = vendor && options.subgroups && has_subgroups(),
                       .to_spirv = options.to_spirv},
          .sparse = epoxy_has_gl_extension("GL_ARB_sparse_buffer"),
          .large_pages = vendor && options.large_pages,
          .vendor_free = options.vendor_free};
}

// Plain buffers have pages of 4 KiB in NVIDIA's driver, which are slow under random access. Buffers smaller than a
// large page stay plain. Opening the driver's memory takes 0.1 s, so it waits for the first large buffer.
BufferStorage BufferMemory::allocate(uint64_t bytes) {
  constexpr uint64_t large_page = 2 << 20;
  const bool large = limits_.large_pages && bytes >= large_page;
  if (large && !std::exchange(opened_, true)) driver_ = DriverMemory::open();
  if (large && driver_) {
    if (const auto storage = driver_->allocate(bytes)) return *storage;
    if (driver_->full()) throw BackendError(out_of_memory(bytes));
    driver_.reset();  // its memory cannot be imported here
  }
  BufferStorage storage;
  glCreateBuffers(1, &storage.buffer);
  const GLbitfield sparse = large && limits_.sparse ? GL_SPARSE_STORAGE_BIT_ARB : 0;
  glNamedBufferStorage(storage.buffer, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT | sparse);
  if (sparse) {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, storage.buffer);
    glBufferPageCommitmentARB(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(bytes), GL_TRUE);
    // Without this wait, work during a commitment of gigabytes makes a driver that also serves CUDA reset the context.
    glFinish();
  }
  if (glGetError() == GL_NO_ERROR) return storage;
  delete_storage(storage);
  throw BackendError(out_of_memory(bytes));
}

std::string texture_too_long(uint64_t texels, const DeviceLimits& limits) {
  return fmt::format(
      "opengl: {} cells or spheres, which do not fit texture buffers of {} texels; leave the texture out", texels,
      limits.largest_texture);
}

BackendInfo describe_device(bool software, const DeviceLimits& limits) {
  BackendInfo info;
  info.name = limits.features.to_spirv ? "opengl-spirv" : limits.vendor_free ? "opengl-core" : "opengl";
  info.language = "GLSL";
  info.device = gl_string(GL_RENDERER);
  info.software = software;
  info.device_timers = !software;  // a software renderer's timers stop before its work does
  info.uuid = device_uuid();
  info.details = {{"GL_RENDERER", gl_string(GL_RENDERER)},
                  {"GL_VENDOR", gl_string(GL_VENDOR)},
                  {"GL_VERSION", gl_string(GL_VERSION)},
                  {"GLSL version", gl_string(GL_SHADING_LANGUAGE_VERSION)},
                  {"largest storage block bytes", std::to_string(limits.largest_binding)},
                  {"largest texture buffer texels", std::to_string(limits.largest_texture)},
                  {"shared memory bytes", std::to_string(gl_integer(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE))},
                  {"64-bit atomics", limits.features.atomics_64 ? "yes" : "no: drawing takes two passes"},
                  {"subgroups", limits.features.subgroups ? "yes" : "no: sums go through shared memory"},
                  {"buffers", storage_in_words(limits)}};
  if (software && std::filesystem::exists("/dev/nvidiactl"))
    info.details["warning"] = "a GPU is present, but OpenGL runs in software";
  return info;
}

}  // namespace spherepair
