// SPDX-License-Identifier: MIT
#include "api/open.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "common/cpu/cpu_backend.h"
#include "common/scene/known_name.h"
#include "common/simulation/simulation.h"
#ifdef SPHEREPAIR_WITH_GLSL
#include "glsl/gl_device.h"
#include "glsl/gl_drawing.h"
#endif
#ifdef SPHEREPAIR_WITH_CUDA
#include "cuda/host/cuda_device.h"
#endif
#ifdef SPHEREPAIR_WITH_VULKAN
#include "vulkan/spirv/compile.h"
#include "vulkan/vulkan_device.h"
#endif
#ifdef SPHEREPAIR_WITH_INTEROP
#include "interop/interop.h"
#endif
#ifdef SPHEREPAIR_WITH_INTEROP_VULKAN
#include "interop/vulkan/vulkan_to_gl.h"
#endif
#ifdef SPHEREPAIR_WITH_INTEROP_VULKAN_CUDA
#include "interop/vulkan_cuda/vulkan_cuda.h"
#endif

namespace spherepair {

std::vector<std::string> backend_names() { return {"cpu", "opengl", "cuda", "vulkan"}; }
std::vector<std::string> gpu_backend_names() { return {"cuda", "vulkan", "opengl"}; }
std::vector<std::string> all_backend_names() {
  return {"cpu", "opengl", "opengl-core", "opengl-spirv", "cuda", "vulkan"};
}

std::string backend_id(const std::string& name) {
  if (name == "glsl") return "opengl";
  if (name == "glsl-core") return "opengl-core";
  const std::vector<std::string> known = all_backend_names();
  if (std::ranges::find(known, name) == known.end()) throw std::invalid_argument(unknown_name("backend", name, known));
  return name;
}

namespace {

std::string& device_option(OpenOptions& options, const std::string& id) {
  return id == "cuda" ? options.cuda_device : id == "vulkan" ? options.vulkan_device : options.gl_device;
}

// The API for which the user named a GPU; empty: none.
std::string api_of_choice(OpenOptions options) {
  for (const char* id : {"cuda", "opengl", "vulkan"})
    if (!device_option(options, id).empty()) return id;
  return {};
}

// Opens the device that the API's own option names.
std::unique_ptr<Device> open_named(const std::string& id, [[maybe_unused]] const OpenOptions& options) {
#ifdef SPHEREPAIR_WITH_CUDA
  if (id == "cuda") return open_cuda_device(options);
#endif
#ifdef SPHEREPAIR_WITH_VULKAN
  if (id == "vulkan") return open_vulkan_device(options);
#endif
#ifdef SPHEREPAIR_WITH_GLSL
  if (id.starts_with("opengl") && (options.to_spirv || id != "opengl-spirv")) return open_gl_device(options);
#endif
  if (id == "cuda") throw BackendError("cuda: not in this build; put nvcc on the PATH and configure again");
  const char* packages = id == "vulkan" ? "libvulkan-dev, glslang-dev, glslang-tools and spirv-tools"
                         : id == "opengl-spirv"
                             ? "libepoxy-dev, libegl-dev, libvulkan-dev, glslang-dev, glslang-tools and spirv-tools"
                             : "libepoxy-dev and libegl-dev";
  throw BackendError(fmt::format("{}: not in this build; install {} and configure again", id, packages));
}

// SPHEREPAIR_CACHE, else `spherepair` in the user's folder for caches. Empty: nothing is kept.
std::string cache_folder() {
  if (const char* own = std::getenv("SPHEREPAIR_CACHE")) return own;
  const char* of_user = std::getenv("XDG_CACHE_HOME");
  if (of_user && *of_user) return fmt::format("{}/spherepair", of_user);
  const char* home = std::getenv("HOME");
  return home && *home ? fmt::format("{}/.cache/spherepair", home) : "";
}

// If the user chose a GPU for another API only, takes the same one. EGL and Vulkan do not know CUDA_VISIBLE_DEVICES:
// they take the first GPU that it leaves to CUDA. They take their own first GPU if it leaves none or they cannot open
// that one.
OpenOptions with_device(const std::string& id, OpenOptions options) {
  if (options.spirv_folder.empty()) options.spirv_folder = cache_folder();
  options.vendor_free = id == "opengl-core" || id == "opengl-spirv";
#ifdef SPHEREPAIR_WITH_VULKAN
  if (id == "opengl-spirv") options.to_spirv = compile_for_opengl;
#endif
  std::string& own = device_option(options, id);
  if (!own.empty() || !options.allow_gpu) return options;
  const std::string other = api_of_choice(options);
  const bool in_window = options.window && id != "vulkan";
  if (other.empty() && (id == "cuda" || in_window || !std::getenv("CUDA_VISIBLE_DEVICES"))) return options;
  try {
    own = open_named(other.empty() ? "cuda" : other, options)->info().uuid;  // none of a software renderer
    if (other.empty()) open_named(id, options);
  } catch (const BackendError& error) {
    if (!other.empty())
      throw BackendError(fmt::format("{}: a GPU was chosen for {}, which cannot be opened; choose one for {}: {}", id,
                                     other, id, error.what()));
    own.clear();
  }
  return options;
}

PipelineOpener pipeline_of_cpu([[maybe_unused]] const OpenOptions& options) {
#ifdef SPHEREPAIR_WITH_GLSL
  return {[options] { return std::make_unique<GlDrawing>(with_device("opengl", options)); }, {Transfer::host}};
#else
  return {};
#endif
}

PipelineOpener pipeline_of_cuda([[maybe_unused]] OpenOptions options, [[maybe_unused]] const Device& device) {
#ifdef SPHEREPAIR_WITH_INTEROP
  if (options.gl_device.empty()) options.gl_device = device.info().uuid;
  return {[options] { return open_cuda_to_gl(options); }, {Transfer::host, Transfer::registered, Transfer::imported}};
#else
  return {};
#endif
}

PipelineOpener pipeline_of_vulkan([[maybe_unused]] OpenOptions options, [[maybe_unused]] Device& device) {
#ifdef SPHEREPAIR_WITH_INTEROP_VULKAN
  if (options.gl_device.empty()) options.gl_device = device.info().uuid;  // none of a software renderer
  std::vector<Transfer> ways = {Transfer::host};
  if (exports_memory(device)) ways.push_back(Transfer::imported);
  return {[options, &device] { return open_vulkan_to_gl(with_device("opengl", options), device); }, ways};
#else
  return {};
#endif
}

PipelineOpener pipeline_of(const OpenOptions& options, Device& device) {
  if (device.pipeline()) return {};  // it has its own
  return device.info().name == "vulkan" ? pipeline_of_vulkan(options, device) : pipeline_of_cuda(options, device);
}

}  // namespace

std::unique_ptr<Device> open_device(const std::string& name, const OpenOptions& options) {
  const std::string id = backend_id(name);
  if (id == "cpu") throw std::invalid_argument("cpu is no device of a GPU's API");
  return open_named(id, with_device(id, options));
}

std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options) {
  if (backend_id(name) == "cpu") return open_cpu_backend(options, pipeline_of_cpu(options));
  std::unique_ptr<Device> device = open_device(name, options);
  const PipelineOpener pipeline = pipeline_of(options, *device);
  return std::make_unique<Simulation>(std::move(device), pipeline);
}

DeviceCopy open_device_copy([[maybe_unused]] Device& from, [[maybe_unused]] Device& to,
                            [[maybe_unused]] uint64_t bytes) {
#ifdef SPHEREPAIR_WITH_INTEROP_VULKAN_CUDA
  return open_vulkan_cuda(from, to, bytes);
#else
  throw BackendError(
      "interop: only Vulkan and CUDA share memory, and this build lacks one of them; transfer spheres as host");
#endif
}

void check_same_gpu(const Backend& left, const Backend& right) {
  const BackendInfo &a = left.info(), &b = right.info();
  if (a.uuid.empty() || b.uuid.empty() || a.uuid == b.uuid) return;
  throw BackendError(
      fmt::format("{} runs on {} ({}) but {} on {} ({}): times would compare two machines; choose one GPU with "
                  "CUDA_VISIBLE_DEVICES, --cuda-device, --gl-device or --vulkan-device",
                  a.name, a.device, a.uuid, b.name, b.device, b.uuid));
}

}  // namespace spherepair
