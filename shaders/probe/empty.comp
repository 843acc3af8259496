#version 450
// SPDX-License-Identifier: MIT
// No thread does anything: measures the cost of a launch.
#include "shaders/kernels.glsl"

layout(local_size_x = BLOCK) in;

void main() {}
