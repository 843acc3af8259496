// SPDX-License-Identifier: MIT
// The threads that share a queue of candidate pairs and wait for each other: in GLSL the work-group, since with
// subgroups NVIDIA's compiler makes collide_grid a seventh slower; in CUDA a warp.
// GLSL only from here: the work-group
const uint COOPERATING = uint(BLOCK);

uint cooperating_index() { return 0u; }
uint cooperating_lane() { return gl_LocalInvocationID.x; }
// Waits for the others, whose writes to shared memory are then visible.
void cooperating_barrier() { barrier(); }
// until here
