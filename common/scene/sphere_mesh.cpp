// SPDX-License-Identifier: MIT
#include "common/scene/sphere_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spherepair {
namespace {

using Triangle = std::array<unsigned, 3>;

struct Builder {
  SphereMesh mesh;
  std::map<std::pair<unsigned, unsigned>, unsigned> middles;

  unsigned add(double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    mesh.corners.push_back({float(x / length), float(y / length), float(z / length)});
    return unsigned(mesh.corners.size() - 1);
  }
  unsigned middle(unsigned a, unsigned b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
    const Corner p = mesh.corners[a], q = mesh.corners[b];
    if (is_new) found->second = add(double(p[0]) + q[0], double(p[1]) + q[1], double(p[2]) + q[2]);
    return found->second;
  }
  void cut(const Triangle& t) {
    const unsigned ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
    for (const Triangle& part : {Triangle{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}})
      mesh.indices.insert(mesh.indices.end(), part.begin(), part.end());
  }
};

}  // namespace

// Makes the paper's sphere. The icosahedron's corners are (0, +-1, +-golden) and its cyclic permutations; a face is
// three corners at distance 2.
SphereMesh sphere_mesh() {
  Builder build;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (int axis = 0; axis < 3; ++axis)
    for (const double one : {-1.0, 1.0})
      for (const double long_side : {-golden, golden}) {
        double at[3] = {};
        at[(axis + 1) % 3] = one;
        at[(axis + 2) % 3] = long_side;
        build.add(at[0], at[1], at[2]);
      }
  const std::vector<Corner> c = build.mesh.corners;
  const auto near = [&](unsigned a, unsigned b) {
    return c[a][0] * c[b][0] + c[a][1] * c[b][1] + c[a][2] * c[b][2] > 0.4f;  // neighbours have 1/sqrt(5)
  };
  for (unsigned i = 0; i < 12; ++i)
    for (unsigned j = i + 1; j < 12; ++j)
      for (unsigned k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(i, k)) continue;
        const float volume = c[i][0] * (c[j][1] * c[k][2] - c[j][2] * c[k][1]) +
                             c[i][1] * (c[j][2] * c[k][0] - c[j][0] * c[k][2]) +
                             c[i][2] * (c[j][0] * c[k][1] - c[j][1] * c[k][0]);
        build.cut(volume > 0 ? Triangle{i, j, k} : Triangle{i, k, j});
      }
  return build.mesh;
}

// Makes GLUT's sphere. The first and the last corner are the poles; between them are rings of `slices` corners.
SphereMesh quadric_mesh(unsigned slices, unsigned stacks) {
  SphereMesh mesh;
  mesh.corners.push_back({0, 0, 1});
  for (unsigned ring = 1; ring < stacks; ++ring)
    for (unsigned slice = 0; slice < slices; ++slice) {
      const double polar = std::numbers::pi * ring / stacks, around = 2 * std::numbers::pi * slice / slices;
      mesh.corners.push_back({float(std::sin(polar) * std::cos(around)), float(std::sin(polar) * std::sin(around)),
                              float(std::cos(polar))});
    }
  mesh.corners.push_back({0, 0, -1});
  const unsigned south = unsigned(mesh.corners.size() - 1);
  const auto add = [&](unsigned a, unsigned b, unsigned c) {
    for (const unsigned corner : {a, b, c}) mesh.indices.push_back(corner);
  };
  for (unsigned slice = 0; slice < slices; ++slice) {
    const unsigned here = 1 + slice, next = 1 + (slice + 1) % slices;
    add(0, here, next);
    for (unsigned below = slices; below < (stacks - 1) * slices; below += slices) {
      const unsigned above = below - slices;
      add(here + above, here + below, next + below);
      add(here + above, next + below, next + above);
    }
    const unsigned last = (stacks - 2) * slices;
    add(south, next + last, here + last);
  }
  return mesh;
}

std::vector<Corner> SphereMesh::unindexed() const {
  std::vector<Corner> all;
  for (const unsigned index : indices) all.push_back(corners[index]);
  return all;
}

}  // namespace spherepair
