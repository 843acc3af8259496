#version 450
// SPDX-License-Identifier: MIT
// A disc, lit as a half sphere; the point's own y grows upwards, the image's downwards.
#include "shaders/draw/scene.glsl"

in vec3 colour;
out vec4 pixel;

void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  float rest = 1.0 - dot(at, at);
  if (rest < 0.0) discard;
  pixel = vec4(colour * light_on(vec3(at.x, at.y, -sqrt(rest))), 1.0);
}
