// SPDX-License-Identifier: MIT
// GLSL only: what the shaders of the graphics pipeline read, the simulation's own buffers by sphere index. Images have
// their first row at the top, so y grows downwards.
#extension GL_ARB_gpu_shader_int64 : require
#include "shaders/draw/view.glsl"
#include "common/shared/draw.h"
#include "common/shared/layout.h"

layout(std430, binding = SLOT_POSITION) restrict readonly buffer PositionBuffer { vec4 position[]; };
layout(std430, binding = SLOT_COUNT) restrict readonly buffer CountBuffer { uint count[]; };

vec3 colour_of(uint sphere) {
  uint colour = palette(count[sphere], v);
  return vec3((colour >> 16) & 255u, (colour >> 8) & 255u, colour & 255u) / 255.0;
}

// A point in the camera's axes. Depth is near / z, so that float32 resolves it evenly; nearer is greater.
vec4 clip_position(vec3 at) {
  vec2 image = vec2(v.focal * at.x, -v.focal * at.y) + at.z * (vec2(v.centre_x, v.centre_y) + 0.5);
  return vec4(2.0 * image / vec2(v.width, v.height) - at.z, v.eye.w, at.z);
}

float light_on(vec3 normal) {
  vec3 facing = normal * v.light.xyz;
  return v.light.w + (1.0 - v.light.w) * clamp(facing.x + facing.y + facing.z, 0.0, 1.0);
}
