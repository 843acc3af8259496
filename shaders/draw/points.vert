#version 450
// SPDX-License-Identifier: MIT
// One point per sphere, as wide as the sphere at its depth; wrong close to the camera, where spheres look oval.
#include "shaders/draw/scene.glsl"

out vec3 colour;

void main() {
  uint sphere = uint(gl_VertexID);
  vec4 seen = in_camera(position[sphere], v);
  colour = colour_of(sphere);
  bool ahead = seen.w > 0.0 && seen.z > v.eye.w;
  gl_Position = ahead ? clip_position(seen.xyz) : vec4(0.0, 0.0, 2.0, 1.0);
  gl_PointSize = max(2.0 * seen.w * v.focal / max(seen.z, v.eye.w), 1.0);
}
