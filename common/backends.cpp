// SPDX-License-Identifier: MIT
// Opens what this build and this machine have: the only place that asks what was built.
#include <fmt/format.h>

#include <algorithm>

#include "backend.h"
#include "cpu_backend.h"
#ifdef SPHEREPAIR_WITH_GLSL
#include "glsl_backend.h"
#endif
#ifdef SPHEREPAIR_WITH_CUDA
#include "cuda_backend.h"
#endif
#include "shared_drawing.h"
#ifdef SPHEREPAIR_WITH_INTEROP
#include "interop.h"
#endif

namespace spherepair {
namespace {

constexpr std::array<const char*, 8> method_names = {
    "sequential",     "parallel",         "collide_group", "collide_tiled",
    "collide_square", "collide_triangle", "collide_grid",  "auto"};
constexpr std::array<const char*, 6> draw_method_names = {"compute",      "mesh_each", "mesh",
                                                          "mesh_indexed", "points",    "impostor"};
constexpr std::array<DrawMethod, 6> draw_methods = {DrawMethod::compute, DrawMethod::mesh_each,
                                                    DrawMethod::mesh,    DrawMethod::mesh_indexed,
                                                    DrawMethod::points,  DrawMethod::impostor};
constexpr std::array<uint, 6> blocks = {32, 64, 128, 256, 512, 1024};

}  // namespace

const char* method_name(Method method) { return method_names[size_t(method)]; }

Method method_from_name(const std::string& name) {
  const auto found = std::ranges::find(method_names, name);
  if (found == method_names.end()) {
    throw std::invalid_argument(fmt::format("unknown method '{}'; known are {}", name, fmt::join(method_names, ", ")));
  }
  return Method(found - method_names.begin());
}

const char* draw_method_name(DrawMethod method) { return draw_method_names[size_t(method)]; }

DrawMethod draw_method_from_name(const std::string& name) {
  const auto found = std::ranges::find(draw_method_names, name);
  if (found == draw_method_names.end()) {
    throw std::invalid_argument(
        fmt::format("unknown method of drawing '{}'; known are {}", name, fmt::join(draw_method_names, ", ")));
  }
  return DrawMethod(found - draw_method_names.begin());
}

std::span<const DrawMethod> all_draw_methods() { return draw_methods; }

std::vector<Method> device_methods() {
  return {Method::collide_group, Method::collide_tiled, Method::collide_square, Method::collide_triangle,
          Method::collide_grid};
}

std::span<const uint> block_sizes() { return blocks; }

std::vector<std::string> backend_names() { return {"cpu", "glsl", "cuda"}; }

std::unique_ptr<Backend> open_backend(const std::string& name, const OpenOptions& options) {
  if (name == "cpu") return open_cpu_backend(options);
  if (name == "glsl") {
#ifdef SPHEREPAIR_WITH_GLSL
    return open_glsl_backend(options);
#else
    throw BackendError("glsl: not in this build; install libepoxy-dev and libegl-dev and configure again");
#endif
  }
  if (name == "cuda") {
#ifdef SPHEREPAIR_WITH_CUDA
    return open_cuda_backend(options);
#else
    throw BackendError("cuda: not in this build; put nvcc on the PATH and configure again");
#endif
  }
  throw std::invalid_argument(
      fmt::format("unknown backend '{}'; known are {}", name, fmt::join(backend_names(), ", ")));
}

const char* hand_over_name(HandOver way) {
  constexpr const char* names[] = {"host", "registered", "imported"};
  return names[size_t(way)];
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
