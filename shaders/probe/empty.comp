#version 450
// SPDX-License-Identifier: MIT
// No thread does anything: what remains is the cost of a launch.
#include "shaders/buffers.glsl"

layout(local_size_x = BLOCK) in;

void main() {}
