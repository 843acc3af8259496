#version 450
// SPDX-License-Identifier: MIT
// Two triangles per sphere that cover its bounding box in pixels, at the depth of the sphere's foremost point.
#include "shaders/draw/scene.glsl"

flat out vec4 seen;
flat out uint sphere;

void main() {
  sphere = uint(gl_VertexID) / 6u;
  uint corner = uint(gl_VertexID) % 6u;
  seen = in_camera(position[sphere], v);
  Box box = Box(0u, 0u, 0u, 0u);
  if (in_frustum(seen, v)) box = box_of(seen, v);
  vec2 side = vec2(corner == 1u || corner == 2u || corner == 4u, corner == 2u || corner == 4u || corner == 5u);
  vec2 image = vec2(box.x, box.y) + side * vec2(box.width, box.height);
  float foremost = max(seen.z - seen.w, v.eye.w);
  gl_Position = vec4(2.0 * image / vec2(v.width, v.height) - 1.0, v.eye.w / foremost, 1.0);
}
