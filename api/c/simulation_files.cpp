// SPDX-License-Identifier: MIT
// The calls that save a simulation and resume it: checkpoints in files and in memory.
#include <fmt/format.h>

#include <algorithm>

#include "api/c/simulation.h"
#include "common/files/checkpoint.h"

using namespace spherepair;

namespace {

Checkpoint checkpoint_of(const sp_simulation& simulation) {
  Motion& motion = *simulation.backend;
  Motion::State state = current_state(motion);
  Checkpoint checkpoint{simulation.scene, motion.save(), simulation.steps};
  checkpoint.scene.positions = std::move(state.positions);
  checkpoint.scene.velocities = std::move(state.velocities);
  return checkpoint;
}

std::filesystem::path path_of(const char* file) {
  if (!file || !*file) refuse("file has no name");
  return std::string_view(file) == "-" ? "./-" : file;  // the program reads standard input by that name
}

// Continues from the checkpoint that read() returns.
template <typename Read>
sp_status resume(const char* backend, const char* device, int32_t threads, sp_simulation** out, Read read) noexcept {
  return guarded(open_message(), [&] {
    if (!out) refuse("out is NULL");
    *out = nullptr;
    Checkpoint saved = read();
    open_simulation(backend, device, threads, std::move(saved.scene), out,
                    [&](Motion& opened, const Scene& scene) { opened.resume(scene, saved.motion); });
    (*out)->steps = saved.step;
    return SP_OK;
  });
}

}  // namespace

sp_status sp_simulation_save(sp_simulation* simulation, const char* file) {
  return on(simulation, [&](Backend&) { write_checkpoint(path_of(file), checkpoint_of(*simulation)); });
}

sp_status sp_simulation_save_bytes(sp_simulation* simulation, void* bytes, size_t room, size_t* size) {
  bool fits = true;
  const sp_status status = on(simulation, [&](Backend&) {
    if (!size) refuse("size is NULL");
    if (room > 0 && !bytes) refuse(fmt::format("bytes is NULL, but room is {}", room));
    const Checkpoint checkpoint = checkpoint_of(*simulation);
    *size = checkpoint_bytes(checkpoint);
    fits = room >= *size;
    if (!fits) {
      simulation->message = fmt::format("the checkpoint has {} bytes, but room is {}", *size, room);
      return;
    }
    auto to = static_cast<char*>(bytes);
    write_checkpoint(checkpoint, [&](std::string_view part) { to = std::ranges::copy(part, to).out; });
  });
  return fits ? status : SP_E_CAPACITY;
}

sp_status sp_simulation_resume(const char* backend, const char* device, int32_t threads, const char* file,
                               sp_simulation** out) {
  return resume(backend, device, threads, out, [&] { return read_checkpoint(path_of(file)); });
}

sp_status sp_simulation_resume_bytes(const char* backend, const char* device, int32_t threads, const void* bytes,
                                     size_t size, sp_simulation** out) {
  return resume(backend, device, threads, out, [&] {
    if (!bytes && size > 0) refuse(fmt::format("bytes is NULL, but size is {}", size));
    const auto given = static_cast<const char*>(bytes);
    return read_checkpoint(FileBytes("the checkpoint", given ? std::string(given, size) : ""));
  });
}
