#version 450
// SPDX-License-Identifier: MIT
// One thread per sphere: the results of the last collision step cleared, for a scene that did not move.
#include "buffers.glsl"

layout(local_size_x = BLOCK) in;

void main() { clear_results(group_index() * BLOCK + gl_LocalInvocationID.x); }
