// SPDX-License-Identifier: MIT
#include "choice.h"

#include "arguments.h"

namespace spherepair {
namespace {

ChosenBackend open_one(const std::string& name, const OpenOptions& options) {
  ChosenBackend chosen;
  chosen.session = std::make_unique<Session>(std::vector{name}, options);
  chosen.backend = chosen.session->find(name);
  return chosen;
}

// Measured in a gas of packing fraction 0.3: from so many spheres on the grid is faster (bench/NOTES.md).
constexpr uint64_t grid_from_on_cpu = 2048, grid_from_on_device = 16384;

Method default_method(const Backend& backend, uint64_t n) {
  const bool cpu = backend.info().name == "cpu";
  if (n >= (cpu ? grid_from_on_cpu : grid_from_on_device)) return Method::collide_grid;
  return cpu ? Method::parallel : Method::collide_triangle;
}

}  // namespace

ChosenBackend choose_backend(const std::string& name, const OpenOptions& options) {
  if (!name.empty()) return open_one(name, options);
  std::vector<std::string> passed_over;
  OpenOptions hardware = options;
  hardware.require_hardware = true;  // OpenGL in software is slower than the CPU backend
  for (const char* device : {"cuda", "glsl"}) {
    if (!options.allow_gpu) break;
    try {
      ChosenBackend chosen = open_one(device, hardware);
      chosen.passed_over = passed_over;
      return chosen;
    } catch (const BackendError& error) {
      passed_over.push_back(error.what());
    }
  }
  ChosenBackend chosen = open_one("cpu", options);
  chosen.passed_over = passed_over;
  return chosen;
}

Method choose_method(const std::string& name, const Backend& backend, uint64_t n) {
  if (name.empty()) return default_method(backend, n);
  std::vector<std::string> known;
  for (Method method : backend.methods()) known.push_back(method_name(method));
  const Method method = method_from_name(name);
  require_known("method of the backend " + backend.info().name + ":", name, known);
  return method;
}

}  // namespace spherepair
