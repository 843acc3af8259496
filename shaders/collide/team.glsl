// SPDX-License-Identifier: MIT
// Teams: threads of a group that go on together while other teams of it are elsewhere. In GLSL the whole group: by
// subgroups, as CUDA by warps, NVIDIA's compiler makes collide_grid a seventh slower.
const uint TEAM = uint(BLOCK);

uint team_index() { return 0u; }
uint team_lane() { return gl_LocalInvocationID.x; }
// Waits for the team, whose writes to shared memory are then seen by all of it.
void team_barrier() { barrier(); }
