// SPDX-License-Identifier: MIT
// Shared by the calls of include/spherepair/simulation.h.
#pragma once

#include "api/c/guarded.h"
#include "include/spherepair/simulation.h"

struct sp_simulation {
  ~sp_simulation() { spherepair::close_for_calls(backend); }

  std::unique_ptr<spherepair::Backend> backend;
  spherepair::Scene scene;  // without the spheres, which the backend has
  uint64_t spheres = 0, steps = 0;
  bool failed = false;  // a step has failed
  std::string message;
};

namespace spherepair {

// Throws ListError for a NaN or an infinity.
void require_finite(double value, const std::string& name);

// The scene that the caller describes. Throws std::invalid_argument.
Scene scene_of(const sp_scene& given);

// Turns options of the program in a message into fields of the C structs: --color-range into color_range.
std::string with_fields_in(std::string message);

// Runs work() with such messages.
template <typename Work>
void with_fields(Work work) {
  try {
    work();
  } catch (const ListError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    refuse(with_fields_in(error.what()));
  }
}

// Opens the backend and calls start(backend, scene), which uploads or resumes the scene. *out gets the simulation.
template <typename Start>
void open_simulation(const char* backend, const char* device, int32_t threads, Scene scene, sp_simulation** out,
                     Start start) {
  auto simulation = std::make_unique<sp_simulation>();
  simulation->backend = open_for_calls(backend, device, threads);
  const InThread in_thread(*simulation->backend);
  with_fields([&] { start(*simulation->backend, scene); });
  simulation->spheres = scene.size();
  std::vector<vec4>().swap(scene.positions), std::vector<vec4>().swap(scene.velocities);
  simulation->scene = std::move(scene);
  *out = simulation.release();
}

// Runs work(backend), unless a step of the simulation failed before.
template <typename Work>
sp_status on(sp_simulation* simulation, Work work) noexcept {
  if (!simulation) return SP_E_ARGUMENT;
  return guarded(simulation->message, [&] {
    if (simulation->failed) refuse("a step of this simulation failed: close it");
    const InThread in_thread(*simulation->backend);
    work(*simulation->backend);
    return SP_OK;
  });
}

}  // namespace spherepair
