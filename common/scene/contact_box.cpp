// SPDX-License-Identifier: MIT
// The box of a scene's contacts: its walls, and the axes along which it repeats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

float& along(vec4& s, int axis) { return axis == 0 ? s.x : axis == 1 ? s.y : s.z; }

bool repeats(const WallBox& box, int axis) { return (box.periodic >> axis & 1) != 0; }

// The upper face of a periodic box is outside: it is the lower face of the next image.
float wrapped(float at, const WallBox& box, int axis) {
  const double low = double(box.low[axis]), period = double(box.high[axis]) - low;
  if (!repeats(box, axis) || (box.low[axis] <= at && at < box.high[axis])) return at;
  const float inside = float(double(at) - period * std::floor((double(at) - low) / period));
  return inside < box.high[axis] ? std::max(inside, box.low[axis]) : box.low[axis];
}

void require_inside(const Scene& scene) {
  const WallBox box = *box_of(scene);
  for (uint64_t i = 0; i < scene.size(); ++i) {
    vec4 s = scene.positions[i];
    for (int axis = 0; axis < 3; ++axis)
      if (const float at = along(s, axis); !repeats(box, axis) && !(box.low[axis] < at && at < box.high[axis]))
        throw std::invalid_argument(
            fmt::format("the centre of sphere {} is at {} = {}, outside of the box from {} to {}: give a larger box", i,
                        "xyz"[axis], at, box.low[axis], box.high[axis]));
  }
}

void take_box(Scene& scene, const ContactChoice& choice) {
  const auto& [low, high, periodic] = *choice.box;
  for (int axis = 0; axis < 3; ++axis)
    if (const bool used = choice.walls || (choice.periodic | periodic) >> axis & 1; used && !(low[axis] < high[axis]))
      throw std::invalid_argument(fmt::format(
          "the box is from {} to {} along {}, but needs a length: give the lower corner first, or omit --walls",
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
  if (scene.positions.empty() && !box_of(scene)) return;
  if (choice.periodic && !box_of(scene))
    throw std::invalid_argument(
        "periodic axes need a box: give --box, or --walls for one around the spheres, or take the scene gas or bed");
  scene.contact.periodic |= choice.periodic;
  if (const auto box = box_of(scene)) wrap_centres(scene, *box);
  if (choice.box && scene.contact.walls) require_inside(scene);
}

uint64_t wrap_centres(Scene& scene, const WallBox& box) {
  uint64_t count = 0;
  for (vec4& s : scene.positions) {
    const vec4 given = s;
    for (int axis = 0; axis < 3; ++axis) along(s, axis) = wrapped(along(s, axis), box, axis);
    count += s.x != given.x || s.y != given.y || s.z != given.z;
  }
  return count;
}

}  // namespace spherepair
