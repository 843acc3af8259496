// SPDX-License-Identifier: MIT
// Teams: threads of a group that go on together while other teams of it are elsewhere. A subgroup, where these are
// known to be 32 consecutive invocations (glsl/device_limits.cpp), else the whole group.
#ifdef SUBGROUPS
const uint TEAM = 32u;
#else
const uint TEAM = uint(BLOCK);
#endif

uint team_index() { return gl_LocalInvocationID.x / TEAM; }
uint team_lane() { return gl_LocalInvocationID.x % TEAM; }
// Waits for the team, whose writes to shared memory are then seen by all of it.
void team_barrier() {
#ifdef SUBGROUPS
  subgroupMemoryBarrierShared();
  subgroupBarrier();
#else
  barrier();
#endif
}
