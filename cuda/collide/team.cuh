// SPDX-License-Identifier: MIT
// Teams: threads of a group that go on together while other teams of it are elsewhere. In CUDA a warp.
#pragma once

#include "common/shared/layout.h"

namespace spherepair {

constexpr uint TEAM = 32u;

__device__ inline uint team_index() { return threadIdx.x / TEAM; }
__device__ inline uint team_lane() { return threadIdx.x % TEAM; }
// Waits for the team, whose writes to shared memory are then seen by all of it.
__device__ inline void team_barrier() { __syncwarp(); }

}  // namespace spherepair
