#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: writes the entry of the palette that its radius or speed chooses.
#include "shaders/draw/view.glsl"
#include "shaders/kernels.glsl"
#include "common/shared/draw.h"

layout(std430, binding = SLOT_COLOUR) restrict writeonly buffer ColourBuffer { uint colour[]; };
layout(local_size_x = BLOCK) in;

void main() {
  uint i = group_index() * BLOCK + gl_LocalInvocationID.x;
  if (i < p.n) colour[i] = palette_entry(position[i], velocity[i], v);
}
