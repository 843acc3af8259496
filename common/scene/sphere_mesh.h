// SPDX-License-Identifier: MIT
// Spheres of triangles: the paper's, and that of GLUT which it compares with.
#pragma once

#include <array>
#include <vector>

namespace spherepair {

using Corner = std::array<float, 3>;

struct SphereMesh {
  std::vector<Corner> corners;            // on the unit sphere
  std::vector<unsigned> indices;          // three a triangle, counter-clockwise seen from outside
  std::vector<Corner> unindexed() const;  // three a triangle
};

// The paper's: an icosahedron whose faces are each cut into four, 42 corners, 80 triangles of 240 vertices.
SphereMesh sphere_mesh();

// That of glutSolidSphere(radius, slices, stacks), poles along z: 10 and 10 in the paper's code 6, 180 triangles.
SphereMesh quadric_mesh(unsigned slices = 10, unsigned stacks = 10);

}  // namespace spherepair
