// SPDX-License-Identifier: MIT
#include "api/open.h"

#include <fmt/format.h>

#include "common/cpu/cpu_backend.h"
#include "common/simulation/simulation.h"
#ifdef SPHEREPAIR_WITH_GLSL
#include "glsl/gl_device.h"
#endif
#ifdef SPHEREPAIR_WITH_CUDA
#include "cuda/host/cuda_device.h"
#endif
#ifdef SPHEREPAIR_WITH_INTEROP
#include "interop/interop.h"
#endif

namespace spherepair {

std::vector<std::string> backend_names() { return {"cpu", "glsl", "cuda"}; }

std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options) {
  if (name == "cpu") return open_cpu_backend(options);
  if (name == "glsl") {
#ifdef SPHEREPAIR_WITH_GLSL
    return std::make_unique<Simulation>(open_gl_device(options));
#else
    throw BackendError("glsl: not in this build; install libepoxy-dev and libegl-dev and configure again");
#endif
  }
  if (name == "cuda") {
#ifdef SPHEREPAIR_WITH_CUDA
    return std::make_unique<Simulation>(open_cuda_device(options));
#else
    throw BackendError("cuda: not in this build; put nvcc on the PATH and configure again");
#endif
  }
  throw std::invalid_argument(
      fmt::format("unknown backend '{}'; known are {}", name, fmt::join(backend_names(), ", ")));
}

std::unique_ptr<SharedDrawing> open_shared_drawing([[maybe_unused]] Backend& cuda,
                                                   [[maybe_unused]] const OpenOptions& options) {
#ifdef SPHEREPAIR_WITH_INTEROP
  return open_cuda_to_gl(cuda, options);
#else
  throw BackendError("interop: this build lacks OpenGL or CUDA");
#endif
}

void check_same_gpu(const Backend& left, const Backend& right) {
  const BackendInfo &a = left.info(), &b = right.info();
  if (a.uuid.empty() || b.uuid.empty() || a.uuid == b.uuid) return;
  throw BackendError(
      fmt::format("{} runs on {} ({}) but {} on {} ({}): times would compare two machines; choose one GPU with "
                  "CUDA_VISIBLE_DEVICES or --cuda-device",
                  a.name, a.device, a.uuid, b.name, b.device, b.uuid));
}

}  // namespace spherepair
