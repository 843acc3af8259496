// SPDX-License-Identifier: MIT
// The paper's sphere: an icosahedron whose faces are each cut into four, 80 triangles of 240 vertices.
#pragma once

#include <array>
#include <vector>

namespace spherepair {

using Corner = std::array<float, 3>;

struct SphereMesh {
  std::vector<Corner> corners;            // 42, on the unit sphere
  std::vector<unsigned> indices;          // 240, three a triangle, counter-clockwise seen from outside
  std::vector<Corner> unindexed() const;  // 240
};
SphereMesh sphere_mesh();

}  // namespace spherepair
