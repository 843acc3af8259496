// SPDX-License-Identifier: MIT
// One thread per LIST_EACH elements: wraps each into its system's box, and adds it to the extremes of the system; the
// group adds up those of its first system.
#include "cuda/list/list_extremes.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_measure(Params p, KernelBuffers buf) {
  uint lane = threadIdx.x;
  uint first = group_index(p) * BLOCK * LIST_EACH + lane;
  uint elements = buf.list_state[0].points + buf.list_state[0].queries;
  if (lane == 0u) group_system = system_of(buf, min(first, elements - 1u));
  if (lane < LIST_EXTREMES) extreme[lane] = 0u;
  __syncthreads();
  Extremes own = no_extremes();
  for (uint k = 0u; k < LIST_EACH; ++k) {
    uint i = first + k * BLOCK;
    if (i < elements) own = measured(buf, own, i, system_of(buf, i));
  }
  add_up(own);
  __syncthreads();
  if (lane < LIST_EXTREMES && extreme[lane] != 0u)
    atomicMax(&buf.list_system[group_system].extreme[lane], extreme[lane]);
}

Entry list_measure_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_measure); }

}  // namespace spherepair
