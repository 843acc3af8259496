// SPDX-License-Identifier: MIT
// What a scene with contacts is uploaded as: parameters, units of state, spheres grown by their skins.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "common/scene/contact_scene.h"
#include "common/shared/contact/skin.h"

namespace spherepair {

float kept_by_drag(const Scene& scene) { return float(std::exp(-0.5 * double(scene.contact.drag) * double(scene.dt))); }

Scene grown_scene(const Scene& scene) {
  const ContactParams c = contact_params(scene);
  Scene grown = scene;
  for (vec4& sphere : grown.positions) sphere = grown_sphere(sphere, c);
  return grown;
}

std::vector<uint> fixed_state(const Scene& scene) {
  const ContactParams c = contact_params(scene);
  const uint64_t n = scene.size();
  std::vector<uint> words(12 * n);
#pragma omp parallel for schedule(static)
  for (uint64_t i = 0; i < n; ++i) {
    const vec4 &at = scene.positions[i], &v = scene.velocities[i];
    const double per_speed = 1 / (double(mobility_of(at.w, c)) * double(c.metres_per_second));
    const auto momentum = [&](float along) { return int64_t(std::llrint(double(along) * per_speed)); };
    const auto units = [&](float along) { return integer_of(std::ldexp(along, c.unit_exponent)); };
    const int64_t half_weight = integer_of(c.gravity * cubed(at.w)) / 2;
    store_body(
        words, n, i,
        {units(at.x), units(at.y), units(at.z), momentum(v.x), momentum(v.y) - half_weight, momentum(v.z), at.w});
  }
  return words;
}

ContactParams contact_params(const Scene& scene) {
  const ContactOptions& contact = scene.contact;
  if (contact.law == ContactLaw::none) return {};
  const int s = contact.unit_exponent, q = contact.momentum_exponent;
  const double k = double(contact.stiffness), dt = double(scene.dt);
  const double density = sphere_mass(1);
  const Radii r = radii_of(scene);
  const int reach = int(exponent_field(r.largest + r.largest)) - 127;
  const double order = contact.law == ContactLaw::quartic ? 3 : contact.law == ContactLaw::hertz ? 1.5 : 1;
  const auto wall = [&](float at) { return integer_of(std::ldexp(at, s)); };
  constexpr int64_t none = 2 * MOST_UNITS;
  return {.low_x = contact.walls ? wall(contact.low.x) : -none,
          .low_y = wall(scene.plane),
          .low_z = contact.walls ? wall(contact.low.z) : -none,
          .high_x = contact.walls ? wall(contact.high.x) : none,
          .high_y = contact.walls ? wall(contact.high.y) : none,
          .high_z = contact.walls ? wall(contact.high.z) : none,
          .law = uint(contact.law),
          .unit_exponent = s,
          .reach_exponent = reach,
          .impulse = float(k * dt * std::exp2(q + order * reach)),
          .damping = float(2 * damping_ratio(double(scene.restitution)) * std::sqrt(k * density) * std::exp2(q - s)),
          .gravity = float(double(scene.gravity) * density * dt * std::exp2(q)),
          .mobility = float(dt / density * std::exp2(s - q)),
          .metres_per_second = float(std::exp2(-s) / dt),
          .fastest = std::ldexp(r.smallest, s),
          .skin = contact.skin,
          .row_capacity = 0};
}

std::string why_beyond_float32(const Scene& scene) {
  const Radii r = radii_of(scene);
  const ContactParams c = contact_params(scene);
  const auto cube = [](float radius) { return std::pow(double(radius), 3); };
  const std::pair<const char*, double> factors[] = {
      {"the cube of the smallest radius", cube(r.smallest)},
      {"the cube of the largest, twice", 2 * cube(r.largest)},
      {"the impulse of a full overlap", double(c.impulse)},
      {"units that a unit of momentum moves a sphere of 1 m", double(c.mobility)},
      {"units that it moves the smallest", double(c.mobility) / cube(r.smallest)},
      {"units that it moves the largest", double(c.mobility) / cube(r.largest)},
      {"metres a second of a unit a step", double(c.metres_per_second)}};
  for (const auto& [what, value] : factors)
    if (!std::isnormal(float(value)))
      return fmt::format(
          "with radii of {:.3g} to {:.3g} m, stiffness {:.3g} and steps of {:.3g} s a factor is beyond float32 ({}): "
          "give "
          "lengths in another unit, in which radii are nearer to 1",
          r.smallest, r.largest, scene.contact.stiffness, scene.dt, what);
  return "";
}

}  // namespace spherepair
