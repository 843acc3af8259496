// SPDX-License-Identifier: MIT
// The calls of include/spherepair/simulation.h that open, move and read.
#include "api/c/simulation.h"

#include <fmt/format.h>

using namespace spherepair;

namespace {

void write_vectors(const std::vector<vec4>& from, const sp_array* to, const char* name) {
  if (!to) return;
  check_array(*to, name, 3, {SP_F32, SP_F64});
  if (uint64_t(to->rows) != from.size())
    refuse(fmt::format("{} has {} rows, but there are {} positions", name, to->rows, from.size()));
  write_array(*to, to->rows, 3, [&](int64_t row, int64_t axis) {
    const vec4& v = from[size_t(row)];
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  });
}

}  // namespace

sp_status sp_simulation_open(const char* backend, const char* device, int32_t threads, const sp_scene* scene,
                             sp_simulation** out) {
  return guarded(open_message(), [&] {
    if (!out) refuse("out is NULL");
    *out = nullptr;
    if (!scene) refuse("scene is NULL");
    Scene start;
    with_fields([&] { start = scene_of(*scene); });
    open_simulation(backend, device, threads, std::move(start), out,
                    [](Motion& opened, const Scene& given) { opened.upload(given); });
    return SP_OK;
  });
}

void sp_simulation_close(sp_simulation* simulation) { delete simulation; }

sp_status sp_simulation_move(sp_simulation* simulation, uint64_t steps) {
  return on(simulation, [&](Motion& motion) {
    simulation->failed = true;  // unless all goes well
    with_fields([&] {
      for (uint64_t k = 0; k < steps; ++k) motion.move();
      motion.finish();
      if (steps > 0) motion.evaluate_state();  // throws if a step failed on the device
    });
    simulation->steps += steps;
    simulation->failed = false;
  });
}

sp_status sp_simulation_state(sp_simulation* simulation, const sp_array* positions, const sp_array* velocities) {
  return on(simulation, [&](Motion& motion) {
    const Motion::State state = current_state(motion);
    write_vectors(state.positions, positions, "positions");
    write_vectors(state.velocities, velocities, "velocities");
  });
}

sp_status sp_simulation_pairs(sp_simulation* simulation, sp_pairs** out) {
  if (out) *out = nullptr;
  return on(simulation, [&](Search& search) {
    if (!out) refuse("out is NULL");
    CollideOptions options;
    options.want_pairs = true;
    search.collide(options);
    const std::vector<Pair> pairs = search.pairs();
    auto owned = std::make_unique<OwnedPairs>(int64_t(pairs.size()), int64_t(simulation->spheres), 0);
    write_array(owned->first, owned->count, 1, [&](int64_t row, int64_t) { return pairs[size_t(row)].first; });
    write_array(owned->second, owned->count, 1, [&](int64_t row, int64_t) { return pairs[size_t(row)].second; });
    *out = owned.release();
  });
}

uint64_t sp_simulation_spheres(const sp_simulation* simulation) { return simulation ? simulation->spheres : 0; }
double sp_simulation_dt(const sp_simulation* simulation) { return simulation ? double(simulation->scene.dt) : 0; }
uint64_t sp_simulation_steps(const sp_simulation* simulation) { return simulation ? simulation->steps : 0; }
const char* sp_simulation_message(const sp_simulation* simulation) {
  return (simulation ? simulation->message : open_message()).c_str();
}
