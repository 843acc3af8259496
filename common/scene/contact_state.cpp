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

}  // namespace spherepair
