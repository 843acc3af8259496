// SPDX-License-Identifier: MIT
// Spheres of triangles: the paper's, and GLUT's, which the paper compares with.
#pragma once

#include <array>
#include <vector>

namespace spherepair {

using Corner = std::array<float, 3>;

struct SphereMesh {
  std::vector<Corner> corners;            // on the unit sphere
  std::vector<unsigned> indices;          // three a triangle, counter-clockwise from outside
  std::vector<Corner> unindexed() const;  // three a triangle
};

// Returns the paper's sphere: an icosahedron with each face cut into four, 42 corners, 80 triangles, 240 vertices.
SphereMesh sphere_mesh();

// Returns glutSolidSphere(radius, slices, stacks), poles along z: 10 and 10 in the paper's code 6, 180 triangles.
SphereMesh quadric_mesh(unsigned slices = 10, unsigned stacks = 10);

}  // namespace spherepair
