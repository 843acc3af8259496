// SPDX-License-Identifier: MIT
// What a scene with contacts is uploaded as: parameters, units of state, spheres grown by their skins.
#include <cmath>

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

}  // namespace spherepair
