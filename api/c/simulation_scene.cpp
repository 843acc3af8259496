// SPDX-License-Identifier: MIT
// The scene that sp_scene describes.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "api/c/simulation.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

float rounded(double value, const std::string& name) {
  require_finite(value, name);
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

// The axes along which the box repeats, as bits.
uint repeats(const sp_scene& given) {
  uint axes = 0;
  for (uint axis = 0; axis < 3; ++axis) {
    if (given.periodic[axis] > 1)
      refuse(fmt::format("periodic[{}] is {}, but must be 0 or 1", axis, given.periodic[axis]));
    axes |= uint(given.periodic[axis]) << axis;
  }
  return axes;
}

ContactChoice contacts_of(const sp_scene& given) {
  ContactChoice choice;
  if (given.contact) choice.law = contact_from_name(given.contact);
  if (choice.law == ContactLaw::none) {
    require_none(given.stiffness != 0, "stiffness");
    require_none(given.density != 0, "density");
    require_none(given.drag != 0, "drag");
    require_none(is_given(given.walls), "walls");
    require_none(repeats(given) != 0, "periodic");
    return choice;
  }
  if (given.stiffness != 0) choice.stiffness = rounded(given.stiffness, "stiffness");
  if (given.dt != 0) choice.dt = rounded(given.dt, "dt");
  if (given.density != 0) choice.density = rounded(given.density, "density");
  choice.drag = rounded(given.drag, "drag");
  choice.walls = is_given(given.walls);
  if (!choice.walls && repeats(given)) refuse("periodic is given, but no box that repeats: give its corners as walls");
  if (!choice.walls) return choice;
  const std::vector<vec4> corners = read_vectors(given.walls, "walls");
  if (corners.size() != 2)
    refuse(fmt::format("walls has {} rows, but must have 2: the lowest corner, the highest", corners.size()));
  choice.box =
      WallBox{{corners[0].x, corners[0].y, corners[0].z}, {corners[1].x, corners[1].y, corners[1].z}, repeats(given)};
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

}  // namespace

void require_finite(double value, const std::string& name) {
  if (!std::isfinite(value)) throw ListError(ListFault::not_finite, name + " is not finite");
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

std::string with_fields_in(std::string message) {
  if (const size_t at = message.find("(render --"); at != std::string::npos) message.erase(at + 1, 7);
  const auto begins_word = [&](size_t at) { return at == 0 || message[at - 1] == ' ' || message[at - 1] == '('; };
  for (size_t at = 0; (at = message.find("--", at)) != std::string::npos; ++at) {
    if (!begins_word(at)) continue;
    message.erase(at, 2);
    for (size_t k = at; k < message.size() && (std::isalpha(message[k]) || message[k] == '-'); ++k)
      if (message[k] == '-') message[k] = '_';
  }
  return message;
}

}  // namespace spherepair
