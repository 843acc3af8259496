// SPDX-License-Identifier: MIT
// Reads and updates which spheres are at rest; see contact_rest.h.
#pragma once

#include "common/shared/contact/contact_rest.h"
#include "cuda/contact/contact_state.cuh"

namespace spherepair {

__device__ inline bool is_at_rest(const Params& p, const KernelBuffers& buf, uint i) {
  return sleep_mode(p.contact) != SLEEP_NEVER && buf.rest[i] == REST_SAME;
}

// Awakens a sphere near one that moved. Threads that awaken the same sphere write the same value.
__device__ inline void awaken(const KernelBuffers& buf, uint i, uint j) {
  bool first_moved = buf.rest[i] == REST_MOVED;
  bool second_moved = buf.rest[j] == REST_MOVED;
  if (first_moved && !second_moved) buf.rest[j] = REST_AWAKENED;
  if (second_moved && !first_moved) buf.rest[i] = REST_AWAKENED;
}

__device__ inline void record_rest(const Params& p, const KernelBuffers& buf, uint i, bool same) {
  if (sleep_mode(p.contact) != SLEEP_NEVER) buf.rest[i] = same ? REST_SAME : REST_MOVED;
}

}  // namespace spherepair
