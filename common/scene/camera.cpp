// SPDX-License-Identifier: MIT
#include "common/scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>

namespace spherepair {
namespace {

glm::dvec3 vector(const Vector& v) { return {v[0], v[1], v[2]}; }
vec4 rounded(const glm::dvec3& v, double w = 0) { return {float(v.x), float(v.y), float(v.z), float(w)}; }

struct Axes {
  glm::dvec3 right, up, forward;
};
Axes axes_of(const Camera& camera) {
  const glm::dvec3 along = vector(camera.target) - vector(camera.eye), up = vector(camera.up);
  const glm::dvec3 across = glm::cross(along, up);
  const double least = 1e-9 * glm::length(along) * glm::length(up);
  if (!(glm::length(across) > least)) {
    throw std::invalid_argument(
        "the camera has no direction: eye and target must differ, and not lie above each other along `up`");
  }
  const glm::dvec3 forward = glm::normalize(along), right = glm::normalize(across);
  return {right, glm::cross(right, forward), forward};
}

// The horizontal directions at azimuth 0 and 90 degrees, and upwards.
struct Horizon {
  glm::dvec3 start, quarter, up;
};
Horizon horizon_of(const Vector& v) {
  if (!(glm::length(vector(v)) > 0))
    throw std::invalid_argument("the up direction is 0,0,0, which is none: give --up such as 0,1,0");
  const glm::dvec3 up = glm::normalize(vector(v)), size = glm::abs(up);
  const int axis = size.y >= size.x && size.y >= size.z ? 1 : size.z >= size.x ? 2 : 0;
  glm::dvec3 next(0);
  next[(axis + 1) % 3] = 1;
  const glm::dvec3 start = glm::normalize(next - glm::dot(next, up) * up);
  return {start, glm::cross(up, start), up};
}

void check_camera(const Camera& camera) {
  if (!(camera.field > 0 && camera.field < 180))
    throw std::invalid_argument(
        fmt::format("--field {}: the field of view must be above 0 and below 180 degrees", camera.field));
  for (const Vector& v : {camera.eye, camera.target, camera.up})
    for (const double x : v)
      if (!(std::abs(x) < 1e15))
        throw std::invalid_argument(
            "--eye, --target, --up or --field makes a coordinate of the camera that is no number below 1e15");
  if (!(camera.near >= 0 && camera.near < 1e15))
    throw std::invalid_argument(fmt::format("the nearest depth is {}, not from 0 to below 1e15", camera.near));
}

float above(double value) { return std::nextafter(float(value), INFINITY); }

}  // namespace

void check_view(const View& view) {
  if (view.width >= 1 && view.width <= widest_image && view.height >= 1 && view.height <= widest_image) return;
  throw std::invalid_argument(
      fmt::format("an image of {} x {} pixels: each must be 1 to {}", view.width, view.height, widest_image));
}

Bounds bounds_of(std::span<const vec4> spheres) {
  Bounds bounds{{1, 1, 1}, {0, 0, 0}};
  for (const vec4& s : spheres) {
    const Vector centre = {s.x, s.y, s.z};
    for (int a = 0; a < 3; ++a) {
      const double low = centre[a] - s.w, high = centre[a] + s.w;
      bounds.low[a] = &s == spheres.data() ? low : std::min(bounds.low[a], low);
      bounds.high[a] = &s == spheres.data() ? high : std::max(bounds.high[a], high);
    }
  }
  return spheres.empty() ? Bounds{{0, 0, 0}, {1, 1, 1}} : bounds;
}

Camera frame(const Bounds& bounds, double azimuth, double elevation, double field, double aspect, const Vector& up) {
  const glm::dvec3 low = vector(bounds.low), high = vector(bounds.high), middle = (low + high) * 0.5;
  const double around = glm::radians(azimuth), over = glm::radians(std::clamp(elevation, -89.0, 89.0));
  const Horizon horizon = horizon_of(up);
  const glm::dvec3 back = std::cos(over) * (std::sin(around) * horizon.quarter + std::cos(around) * horizon.start) +
                          std::sin(over) * horizon.up;
  Camera camera{{back.x, back.y, back.z}, {0, 0, 0}, up, field};
  const Axes axes = axes_of(camera);
  const double half_y = std::tan(glm::radians(field) / 2) / 1.05, half_x = half_y * aspect;  // 5 % of margin
  double distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    const glm::dvec3 from = at - middle;
    const double nearer = -glm::dot(from, axes.forward);
    const double wide = std::abs(glm::dot(from, axes.right)) / half_x,
                 tall = std::abs(glm::dot(from, axes.up)) / half_y;
    distance = std::max(distance, nearer + std::max(wide, tall));
  }
  if (distance == 0) distance = 1;
  const glm::dvec3 eye = middle + back * distance;
  camera.eye = {eye.x, eye.y, eye.z};
  camera.target = {middle.x, middle.y, middle.z};
  return camera;
}

Look range_look(uint colour_by, double lowest, double highest) {
  Look look{.palette = {0x440154, 0x46327E, 0x365C8D, 0x277F8E, 0x1FA187, 0x4AC16D, 0xA0DA39, 0xFDE725}};
  look.colour_by = colour_by;
  for (int k = 0; k < COLOURS - 1; ++k) look.limits[k] = lowest + (highest - lowest) * (k + 1) / COLOURS;
  return look;
}

Look contact_look() {
  return {.palette = {0x9FB4CC, 0xFFEDA0, 0xFED976, 0xFEB24C, 0xFD8D3C, 0xFC4E2A, 0xE31A1C, 0xB10026}};
}

View make_view(const Camera& camera, const Look& look, uint width, uint height, std::array<double, 2> jitter) {
  check_camera(camera);
  View v{};
  v.width = width;
  v.height = height;
  check_view(v);
  const Axes axes = axes_of(camera);
  const double distance = glm::length(vector(camera.target) - vector(camera.eye));
  const double near = camera.near > 0 ? camera.near : distance * 1e-3;
  const double focal = height / 2.0 / std::tan(glm::radians(camera.field) / 2);
  v.eye = rounded(vector(camera.eye), near);
  v.right = rounded(axes.right);
  v.up = rounded(axes.up);
  v.forward = rounded(axes.forward);
  v.light = rounded(glm::normalize(vector(look.light)), look.ambient);
  const glm::dvec3 light = glm::normalize(vector(look.light));
  const glm::dvec3 sun = light.x * axes.right + light.y * axes.up + light.z * axes.forward;
  const glm::dvec3 normal = glm::normalize(vector(look.ground_normal));
  if (look.lighting & LIGHT_GROUND && glm::dot(sun, normal) < 0.2)
    throw std::invalid_argument(
        "the camera's light does not come from above the ground: look from higher up, tilt the camera less, or leave "
        "the ground out (render --ground none; with lowest it follows --up)");
  v.ground = rounded(normal, look.ground);
  v.sun = rounded(sun, look.shadow);
  v.lighting = look.lighting;
  v.focal = float(focal);
  v.pixel = float(1 / focal);
  v.centre_x = float(width / 2.0 - 0.5 + jitter[0]);
  v.centre_y = float(height / 2.0 - 0.5 + jitter[1]);
  v.half_x = above((width / 2.0 + 2) / focal);  // leaves room for the jitter and a pixel
  v.half_y = above((height / 2.0 + 2) / focal);
  v.norm_x = above(std::hypot(1.0, double(v.half_x)) * (1 + 1e-6));
  v.norm_y = above(std::hypot(1.0, double(v.half_y)) * (1 + 1e-6));
  v.palette_0 = {look.palette[0], look.palette[1], look.palette[2], look.palette[3]};
  v.palette_4 = {look.palette[4], look.palette[5], look.palette[6], look.palette[7]};
  v.background = look.background;
  v.colour_by = look.colour_by;
  const auto limit = [&](int k) {
    return float(look.colour_by == COLOUR_BY_SPEED ? look.limits[k] * look.limits[k] : look.limits[k]);
  };
  v.limits_0 = {limit(0), limit(1), limit(2), limit(3)};
  v.limit_4 = limit(4), v.limit_5 = limit(5), v.limit_6 = limit(6);
  return v;
}

}  // namespace spherepair
