#version 450
// SPDX-License-Identifier: MIT
// The paper's code 9: a vertex of the mesh, moved to its sphere, lit by the angle of its normal to the light, coloured by
// its sphere's contacts. An instance is a sphere; with one draw call per sphere, `first` is its index.
#include "shaders/draw/scene.glsl"

layout(location = 0) uniform uint first;
layout(location = 0) in vec3 corner;  // on the unit sphere: the normal too
out vec3 colour;

void main() {
  uint sphere = first + uint(gl_InstanceID);
  vec4 seen = in_camera(position[sphere], v);
  vec3 normal = vec3(dot(corner, v.right.xyz), dot(corner, v.up.xyz), dot(corner, v.forward.xyz));
  colour = colour_of(sphere) * light_on(normal);
  gl_Position = seen.w > 0.0 ? clip_position(seen.xyz + seen.w * normal) : vec4(0.0, 0.0, 2.0, 1.0);
}
