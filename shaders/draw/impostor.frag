#version 450
// SPDX-License-Identifier: MIT
// The exact intersection of ray and sphere, as in draw_spheres and draw_resolve; never nearer than its triangles.
#include "shaders/draw/scene.glsl"

flat in vec4 seen;
flat in uint sphere;
layout(depth_less) out float gl_FragDepth;
out vec4 pixel;

void main() {
  Ray ray = ray_through(uint(gl_FragCoord.x), uint(gl_FragCoord.y), v);
  float depth = depth_of_hit(seen, ray, v);
  if (depth == 0.0) discard;
  gl_FragDepth = v.eye.w * ray.a / depth;
  pixel = unpackUnorm4x8(shade(seen, ray, depth, count[sphere], v));
}
