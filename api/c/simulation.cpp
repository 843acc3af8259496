// SPDX-License-Identifier: MIT
// The calls of include/spherepair/simulation.h.
#include "include/spherepair/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "api/c/guarded.h"
#include "common/scene/contact_scene.h"

using namespace spherepair;

struct sp_simulation {
  ~sp_simulation() { close_for_calls(backend); }

  std::unique_ptr<Backend> backend;
  uint64_t spheres = 0, steps = 0;
  double dt = 0;
  bool failed = false;  // a step has failed
  std::string message;
};

namespace {

// Runs work() and turns options of the program in its messages into fields of sp_scene: --stiffness into stiffness.
template <typename Work>
void with_fields(Work work) {
  try {
    work();
  } catch (const ListError&) {
    throw;
  } catch (const std::invalid_argument& error) {
    std::string message = error.what();
    for (size_t at; (at = message.find("--")) != std::string::npos;) message.erase(at, 2);
    refuse(message);
  }
}

float rounded(double value, const std::string& name) {
  if (!std::isfinite(value)) throw ListError(ListFault::not_finite, name + " is not finite");
  if (!std::isfinite(float(value)))
    throw ListError(ListFault::range, fmt::format("{} is {}, beyond float32", name, value));
  return float(value);
}

std::vector<vec4> read_vectors(const sp_array& array, const std::string& name) {
  const std::vector<Point3> rows = read_points(array, name);
  const auto component = [&](uint64_t i, size_t axis) {
    const double value = rows[i][axis];
    return std::isfinite(float(value)) ? float(value) : rounded(value, fmt::format("{}[{}].{}", name, i, "xyz"[axis]));
  };
  std::vector<vec4> vectors;
  for (uint64_t i = 0; i < rows.size(); ++i) vectors.push_back({component(i, 0), component(i, 1), component(i, 2), 0});
  return vectors;
}

void require_rows(const sp_array& array, const char* name, uint64_t spheres) {
  if (uint64_t(array.rows) != spheres)
    refuse(fmt::format("{} has {} rows, but there are {} positions", name, array.rows, spheres));
}

void require_none(bool given, const char* name) {
  if (given)
    refuse(fmt::format("{} is given, but without a contact law it has no meaning: name one, or leave it out", name));
}

ContactChoice contacts_of(const sp_scene& given) {
  ContactChoice choice;
  if (given.contact) choice.law = contact_from_name(given.contact);
  if (choice.law == ContactLaw::none) {
    require_none(given.stiffness != 0, "stiffness");
    require_none(given.density != 0, "density");
    require_none(given.drag != 0, "drag");
    require_none(is_given(given.walls), "walls");
    return choice;
  }
  if (given.stiffness != 0) choice.stiffness = rounded(given.stiffness, "stiffness");
  if (given.dt != 0) choice.dt = rounded(given.dt, "dt");
  if (given.density != 0) choice.density = rounded(given.density, "density");
  choice.drag = rounded(given.drag, "drag");
  choice.walls = is_given(given.walls);
  if (!choice.walls) return choice;
  const std::vector<vec4> corners = read_vectors(given.walls, "walls");
  if (corners.size() != 2)
    refuse(fmt::format("walls has {} rows, but must have 2: the lowest corner, the highest", corners.size()));
  choice.box = WallBox{{corners[0].x, corners[0].y, corners[0].z}, {corners[1].x, corners[1].y, corners[1].z}};
  return choice;
}

// Refuses spheres below the plane: the first step would lift them.
void require_above_plane(const Scene& scene) {
  const bool contacts = scene.contact.law != ContactLaw::none;
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const vec4& sphere = scene.positions[i];
    const double lowest = contacts ? double(sphere.y) : double(sphere.y) - double(sphere.w);
    if (lowest < double(scene.plane))
      refuse(fmt::format("sphere {} {} y = {}, below the plane at {}: lower the plane", i,
                         contacts ? "has its centre at" : "reaches down to", lowest, scene.plane));
  }
}

Scene scene_of(const sp_scene& given) {
  if (given.size != sizeof(sp_scene))
    refuse(fmt::format("scene.size is {}, but sizeof(sp_scene) is {}: the program was compiled with another header",
                       given.size, sizeof(sp_scene)));
  Scene scene{.name = "scene"};
  scene.positions = read_vectors(given.positions, "positions");
  require_rows(given.radii, "radii", scene.size());
  const std::vector<double> radii = read_numbers(given.radii, "radii", 1);
  for (uint64_t i = 0; i < scene.size(); ++i) scene.positions[i].w = rounded(radii[i], fmt::format("radii[{}]", i));
  scene.equal_radii = std::ranges::all_of(scene.positions, [&](const vec4& s) { return s.w == scene.positions[0].w; });
  scene.velocities.resize(scene.size(), vec4{0, 0, 0, 0});
  if (is_given(given.velocities)) {
    require_rows(given.velocities, "velocities", scene.size());
    scene.velocities = read_vectors(given.velocities, "velocities");
  }
  scene.plane = rounded(given.plane, "plane");
  scene.gravity = 0 - rounded(given.gravity, "gravity");
  scene.restitution = rounded(given.restitution, "restitution");
  if (given.dt != 0) scene.dt = rounded(given.dt, "dt");
  scene.motion = {MotionMethod::anchored, Precision::float32};
  check_scene(scene);
  choose_contacts(scene, contacts_of(given));
  require_above_plane(scene);
  if (const std::string why = why_unmovable(scene); !why.empty()) throw std::invalid_argument(why);
  return scene;
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

void write_vectors(const std::vector<vec4>& from, const sp_array* to, const char* name) {
  if (!to) return;
  check_array(*to, name, 3, {SP_F32, SP_F64});
  require_rows(*to, name, from.size());
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
    auto simulation = std::make_unique<sp_simulation>();
    Scene start;
    with_fields([&] { start = scene_of(*scene); });
    simulation->backend = open_for_calls(backend, device, threads);
    const InThread in_thread(*simulation->backend);
    with_fields([&] { simulation->backend->upload(start); });
    simulation->spheres = start.size(), simulation->dt = double(start.dt);
    *out = simulation.release();
    return SP_OK;
  });
}

void sp_simulation_close(sp_simulation* simulation) { delete simulation; }

sp_status sp_simulation_move(sp_simulation* simulation, uint64_t steps) {
  return on(simulation, [&](Backend& backend) {
    simulation->failed = true;  // unless all goes well
    with_fields([&] {
      for (uint64_t k = 0; k < steps; ++k) backend.move();
      backend.finish();
      if (steps > 0) backend.evaluate_state();  // throws if a step failed on the device
    });
    simulation->steps += steps;
    simulation->failed = false;
  });
}

sp_status sp_simulation_state(sp_simulation* simulation, const sp_array* positions, const sp_array* velocities) {
  return on(simulation, [&](Backend& backend) {
    const Backend::State state = current_state(backend);
    write_vectors(state.positions, positions, "positions");
    write_vectors(state.velocities, velocities, "velocities");
  });
}

sp_status sp_simulation_pairs(sp_simulation* simulation, sp_pairs** out) {
  if (out) *out = nullptr;
  return on(simulation, [&](Backend& backend) {
    if (!out) refuse("out is NULL");
    CollideOptions options;
    options.want_pairs = true;
    backend.collide(options);
    const std::vector<Pair> pairs = backend.pairs();
    auto owned = std::make_unique<OwnedPairs>(int64_t(pairs.size()), int64_t(simulation->spheres), 0);
    write_array(owned->first, owned->count, 1, [&](int64_t row, int64_t) { return pairs[size_t(row)].first; });
    write_array(owned->second, owned->count, 1, [&](int64_t row, int64_t) { return pairs[size_t(row)].second; });
    *out = owned.release();
  });
}

double sp_simulation_dt(const sp_simulation* simulation) { return simulation ? simulation->dt : 0; }
uint64_t sp_simulation_steps(const sp_simulation* simulation) { return simulation ? simulation->steps : 0; }
const char* sp_simulation_message(const sp_simulation* simulation) {
  return (simulation ? simulation->message : open_message()).c_str();
}
