// SPDX-License-Identifier: MIT
#include "bench/image/box_edges.h"

#include "bench/image/canvas.h"

namespace spherepair {
namespace {

constexpr uint ink = 0x707070;
constexpr double in_front = 1 - 1e-3;  // spheres that touch an edge do not hide it

// Camera coordinates: right, up and forward, metres.
Vector in_axes(const Vector& at, const View& v) {
  const double x = at[0] - v.eye.x, y = at[1] - v.eye.y, z = at[2] - v.eye.z;
  const auto along = [&](const vec4& axis) { return x * axis.x + y * axis.y + z * axis.z; };
  return {along(v.right), along(v.up), along(v.forward)};
}

Point on_image(const Vector& seen, const View& v) {
  return {v.centre_x + seen[0] / seen[2] * v.focal, v.centre_y - seen[1] / seen[2] * v.focal};
}

Vector between(const Vector& a, const Vector& b, double share) {
  Vector at;
  for (int axis = 0; axis < 3; ++axis) at[axis] = a[axis] + (b[axis] - a[axis]) * share;
  return at;
}

}  // namespace

void draw_edges(std::vector<uint>& image, const std::vector<double>& ahead, const View& v, const Bounds& box) {
  Canvas canvas(image, v.width, v.height);
  const double thickness = std::max(1.0, v.height / 540.0), near = v.eye.w;
  const auto corner = [&](int k) {
    return in_axes(
        {k & 1 ? box.high[0] : box.low[0], k & 2 ? box.high[1] : box.low[1], k & 4 ? box.high[2] : box.low[2]}, v);
  };
  for (int from = 0; from < 8; ++from)
    for (const int axis : {1, 2, 4}) {
      Vector a = corner(from), b = corner(from | axis);
      if (from & axis || (a[2] < near && b[2] < near)) continue;
      if (a[2] < near) a = between(a, b, (near - a[2]) / (b[2] - a[2]));
      if (b[2] < near) b = between(b, a, (near - b[2]) / (a[2] - b[2]));
      canvas.stroke(on_image(a, v), on_image(b, v), thickness, ink, [&](int x, int y, double along) {
        const double edge = 1 / ((1 - along) / a[2] + along / b[2]);
        return in_front * edge <= ahead[size_t(y) * v.width + size_t(x)];
      });
    }
}

}  // namespace spherepair
