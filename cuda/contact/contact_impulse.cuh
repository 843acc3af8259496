// SPDX-License-Identifier: MIT
// Adds impulses to spheres in any order, and takes their sums.
#pragma once

#include "cuda/contact/contact_state.cuh"

namespace spherepair {

// CUDA only from here: its atomic is of unsigned numbers
__device__ inline int64_t load_from_impulse(const KernelBuffers& buf, uint k, uint i) { return buf.impulse[k][i]; }
__device__ inline void clear_impulse(const KernelBuffers& buf, uint k, uint i, int64_t sum) {
  if (sum != 0) buf.impulse[k][i] = 0;
}
__device__ inline void add_to_impulse(const KernelBuffers& buf, uint k, uint i, float value) {
  unsigned long long* sum = reinterpret_cast<unsigned long long*>(&buf.impulse[k][i]);
  atomicAdd(sum, static_cast<unsigned long long>(integer_of(value)));
}
// until here

__device__ inline void add_impulse(const KernelBuffers& buf, uint i, float x, float y, float z) {
  add_to_impulse(buf, 0u, i, x);
  add_to_impulse(buf, 1u, i, y);
  add_to_impulse(buf, 2u, i, z);
}

// Returns the sum of the impulses that were added.
__device__ inline Push load_impulse(const KernelBuffers& buf, uint i) {
  return Push{load_from_impulse(buf, 0u, i), load_from_impulse(buf, 1u, i), load_from_impulse(buf, 2u, i), FAULTS};
}
// Sets that sum to 0 for the next step.
__device__ inline void clear_impulses(const KernelBuffers& buf, uint i, Push sum) {
  clear_impulse(buf, 0u, i, sum.x);
  clear_impulse(buf, 1u, i, sum.y);
  clear_impulse(buf, 2u, i, sum.z);
}

}  // namespace spherepair
