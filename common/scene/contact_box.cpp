// SPDX-License-Identifier: MIT
// The box of a scene's contacts: its walls, and the axes along which it repeats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

// A centre on the upper face of a periodic box would be its image's on the lower one.
bool is_inside(float at, const WallBox& box, int axis) {
  const bool repeats = (box.periodic >> axis & 1) != 0;
  return at < box.high[axis] && (repeats ? box.low[axis] <= at : box.low[axis] < at);
}

void require_inside(const Scene& scene) {
  const WallBox box = *box_of(scene);
  for (uint64_t i = 0; i < scene.size(); ++i) {
    const vec4& s = scene.positions[i];
    const float at[3] = {s.x, s.y, s.z};
    for (int axis = 0; axis < 3; ++axis) {
      const bool repeats = (box.periodic >> axis & 1) != 0;
      if ((!repeats && !scene.contact.walls) || is_inside(at[axis], box, axis)) continue;
      throw std::invalid_argument(
          fmt::format("the centre of sphere {} is at {} = {}, outside of the box from {} to {}: {}", i, "xyz"[axis],
                      at[axis], box.low[axis], box.high[axis],
                      repeats ? "wrap it into the periodic box, below its upper face" : "give a larger --box"));
    }
  }
}

void take_box(Scene& scene, const ContactChoice& choice) {
  const auto& [low, high, periodic] = *choice.box;
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] < high[axis]))
      throw std::invalid_argument(fmt::format("the box is from {} to {} along {}: give the lower corner first",
                                              low[axis], high[axis], "xyz"[axis]));
  ContactOptions& contact = scene.contact;
  contact.walls = choice.walls, contact.periodic = periodic;
  if (choice.walls || (choice.periodic | periodic) & 2) scene.plane = low[1];
  contact.low = {low[0], low[1], low[2], 0}, contact.high = {high[0], high[1], high[2], 0};
}

void box_around_spheres(Scene& scene, bool walls) {
  ContactOptions& contact = scene.contact;
  if (contact.walls || !walls || scene.positions.empty()) return;
  contact.walls = true;
  contact.low = {INFINITY, scene.plane, INFINITY, 0}, contact.high = {-INFINITY, -INFINITY, -INFINITY, 0};
  for (const vec4& s : scene.positions) {
    contact.low.x = std::min(contact.low.x, s.x - s.w), contact.high.x = std::max(contact.high.x, s.x + s.w);
    contact.low.z = std::min(contact.low.z, s.z - s.w), contact.high.z = std::max(contact.high.z, s.z + s.w);
    contact.high.y = std::max(contact.high.y, s.y + s.w);
  }
}

}  // namespace

std::optional<WallBox> box_of(const Scene& scene) {
  const vec4 &low = scene.contact.low, &high = scene.contact.high;
  if (!scene.contact.walls && !scene.contact.periodic) return std::nullopt;
  const float bottom = scene.contact.walls || scene.contact.periodic & 2 ? scene.plane : low.y;
  return WallBox{{low.x, bottom, low.z}, {high.x, high.y, high.z}, scene.contact.periodic};
}

double period_of(const Scene& scene, int axis) {
  if (!(scene.contact.periodic >> axis & 1)) return 0;
  const WallBox box = *box_of(scene);
  return double(box.high[axis]) - double(box.low[axis]);
}

double least_period(const Scene& scene) {
  return 4 * double(radii_of(scene).largest) * (1 + 2 * double(scene.contact.skin));
}

void choose_box(Scene& scene, const ContactChoice& choice) {
  choice.box ? take_box(scene, choice) : box_around_spheres(scene, choice.walls);
  if (choice.periodic && !box_of(scene))
    throw std::invalid_argument(
        "periodic axes need a box: give --box, or --walls for one around the spheres, or take the scene gas or bed");
  scene.contact.periodic |= choice.periodic;
  if (choice.box || choice.periodic) require_inside(scene);
}

}  // namespace spherepair
