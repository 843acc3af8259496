// SPDX-License-Identifier: MIT
// The threads that share a queue of candidate pairs and wait for each other: in GLSL the work-group, since with
// subgroups NVIDIA's compiler makes collide_grid a seventh slower; in CUDA a warp.
#pragma once

#include "common/shared/layout.h"

namespace spherepair {

// CUDA only from here: a warp
constexpr uint COOPERATING = 32u;

__device__ inline uint cooperating_index() { return threadIdx.x / COOPERATING; }
__device__ inline uint cooperating_lane() { return threadIdx.x % COOPERATING; }
// Waits for the others, whose writes to shared memory are then visible.
__device__ inline void cooperating_barrier() { __syncwarp(); }
// until here

}  // namespace spherepair
