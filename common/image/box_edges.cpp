// SPDX-License-Identifier: MIT
#include "common/image/box_edges.h"

#include "common/image/canvas.h"

namespace spherepair {
namespace {

constexpr double in_front = 1 - 1e-3;  // spheres that touch an edge do not hide it
constexpr uint edge_colour = 0x707070;

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

struct Edge {
  Vector a, b;  // in camera coordinates, not nearer than the near plane
};

std::vector<Edge> edges_in_front(const View& v, const Bounds& box) {
  const double near = v.eye.w;
  const auto corner = [&](int k) {
    return in_axes(
        {k & 1 ? box.high[0] : box.low[0], k & 2 ? box.high[1] : box.low[1], k & 4 ? box.high[2] : box.low[2]}, v);
  };
  std::vector<Edge> edges;
  for (int from = 0; from < 8; ++from)
    for (int axis = 0; axis < 3; ++axis) {
      Vector a = corner(from), b = corner(from | 1 << axis);
      if (from >> axis & 1 || (a[2] < near && b[2] < near)) continue;
      if (a[2] < near) a = between(a, b, (near - a[2]) / (b[2] - a[2]));
      if (b[2] < near) b = between(b, a, (near - b[2]) / (a[2] - b[2]));
      edges.push_back({a, b});
    }
  return edges;
}

}  // namespace

void draw_edges(std::vector<uint>& image, const std::vector<double>& ahead, const View& v, const Bounds& box) {
  Canvas canvas(image, v.width, v.height);
  const double thickness = std::max(1.0, v.height / 540.0);  // pixels
  for (const Edge& edge : edges_in_front(v, box)) {
    const double a = edge.a[2], b = edge.b[2];
    canvas.stroke(on_image(edge.a, v), on_image(edge.b, v), thickness, edge_colour, [&](int x, int y, double along) {
      const double distance = 1 / ((1 - along) / a + along / b);
      return in_front * distance <= ahead[size_t(y) * v.width + size_t(x)];
    });
  }
}

}  // namespace spherepair
