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
#include "vulkan/vulkan_device.h"
#endif
#ifdef SPHEREPAIR_WITH_INTEROP
#include "interop/interop.h"
#endif

namespace spherepair {

std::vector<std::string> backend_names() { return {"cpu", "opengl", "cuda", "vulkan"}; }
std::vector<std::string> all_backend_names() { return {"cpu", "opengl", "opengl-core", "cuda", "vulkan"}; }

std::string backend_id(const std::string& name) {
  if (name == "glsl") return "opengl";
  if (name == "glsl-core") return "opengl-core";
  const std::vector<std::string> known = all_backend_names();
  if (std::ranges::find(known, name) == known.end()) throw std::invalid_argument(unknown_name("backend", name, known));
  return name;
}

namespace {

// Where a GPU was chosen for one API alone, the other takes the same. EGL does not know CUDA_VISIBLE_DEVICES: OpenGL
// takes the first GPU that it leaves to CUDA, and its own first where it leaves none or OpenGL does not reach that one.
#ifdef SPHEREPAIR_WITH_GLSL
OpenOptions with_gl_device(OpenOptions options, bool vendor_free = false) {
  options.vendor_free = vendor_free;
  const bool chosen = !options.cuda_device.empty();
  const bool narrowed = std::getenv("CUDA_VISIBLE_DEVICES") && !options.window;
  if (!options.gl_device.empty() || !options.allow_gpu || !(chosen || narrowed)) return options;
#ifdef SPHEREPAIR_WITH_CUDA
  try {
    options.gl_device = open_cuda_device(options)->info().uuid;
    if (!chosen) open_gl_device(options);
  } catch (const BackendError&) {
    if (chosen) throw;
    options.gl_device.clear();
  }
#else
  if (chosen) throw BackendError("opengl: a CUDA device was chosen, but this build lacks CUDA; use --gl-device");
#endif
  return options;
}
#endif

#ifdef SPHEREPAIR_WITH_CUDA
OpenOptions with_cuda_device(OpenOptions options) {
  if (options.gl_device.empty() || !options.cuda_device.empty()) return options;
#ifdef SPHEREPAIR_WITH_GLSL
  options.cuda_device = open_gl_device(options)->info().uuid;  // none of a software renderer
#endif
  return options;
}
#endif

#ifdef SPHEREPAIR_WITH_VULKAN
// The GPU that was chosen for another API, or that CUDA_VISIBLE_DEVICES leaves first to CUDA if Vulkan reaches it.
OpenOptions with_vulkan_device(OpenOptions options) {
  const bool chosen = !options.cuda_device.empty() || !options.gl_device.empty();
  if (!options.vulkan_device.empty() || !options.allow_gpu || !(chosen || std::getenv("CUDA_VISIBLE_DEVICES")))
    return options;
  const std::string other = options.gl_device.empty() ? "cuda" : "opengl";
  try {
    options.vulkan_device = open_device(other, options)->info().uuid;
    if (!chosen) open_vulkan_device(options);
  } catch (const BackendError& error) {
    if (chosen)
      throw BackendError(fmt::format("vulkan: it takes the device of {}, which is missing; use --vulkan-device: {}",
                                     other, error.what()));
    options.vulkan_device.clear();
  }
  return options;
}
#endif

PipelineOpener pipeline_of_cpu([[maybe_unused]] const OpenOptions& options) {
#ifdef SPHEREPAIR_WITH_GLSL
  return [options] { return std::make_unique<GlDrawing>(with_gl_device(options)); };
#else
  return {};
#endif
}

PipelineOpener pipeline_of_cuda([[maybe_unused]] OpenOptions options, [[maybe_unused]] const Device& device) {
  if (device.info().name != "cuda") return {};
#ifdef SPHEREPAIR_WITH_INTEROP
  if (options.gl_device.empty()) options.gl_device = device.info().uuid;
  return [options] { return open_cuda_to_gl(options); };
#else
  return {};
#endif
}

}  // namespace

std::unique_ptr<Device> open_device(const std::string& name, [[maybe_unused]] const OpenOptions& options) {
  const std::string id = backend_id(name);
  if (id == "cpu") throw std::invalid_argument("cpu is no device of a GPU's API");
#ifdef SPHEREPAIR_WITH_VULKAN
  if (id == "vulkan") return open_vulkan_device(with_vulkan_device(options));
#endif
  if (id == "vulkan")
    throw BackendError(
        "vulkan: not in this build; install libvulkan-dev, glslang-dev and spirv-tools, and configure again");
#ifdef SPHEREPAIR_WITH_GLSL
  if (id != "cuda") return open_gl_device(with_gl_device(options, id == "opengl-core"));
#endif
#ifdef SPHEREPAIR_WITH_CUDA
  if (id == "cuda") return open_cuda_device(with_cuda_device(options));
#endif
  if (id == "cuda") throw BackendError("cuda: not in this build; put nvcc on the PATH and configure again");
  throw BackendError(id + ": not in this build; install libepoxy-dev and libegl-dev and configure again");
}

std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options) {
  if (backend_id(name) == "cpu") return open_cpu_backend(options, pipeline_of_cpu(options));
  std::unique_ptr<Device> device = open_device(name, options);
  const PipelineOpener pipeline = device->pipeline() ? PipelineOpener{} : pipeline_of_cuda(options, *device);
  return std::make_unique<Simulation>(std::move(device), pipeline);
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
