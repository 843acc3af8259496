#version 450
// SPDX-License-Identifier: MIT
// A disc, lit as the half sphere that it stands for; the point's own y grows upwards in an image that grows downwards.
#include "shaders/draw/scene.glsl"

in vec3 colour;
out vec4 pixel;

void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  float rest = 1.0 - dot(at, at);
  if (rest < 0.0) discard;
  pixel = vec4(colour * light_on(vec3(at.x, at.y, -sqrt(rest))), 1.0);
}
