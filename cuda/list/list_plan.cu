// SPDX-License-Identifier: MIT
// One thread per system: its cells.
#include "common/shared/list_plan.h"
#include "cuda/list/list.cuh"

namespace spherepair {

constexpr uint BLOCK = SERVICE_BLOCK;

__global__ void __launch_bounds__(BLOCK) list_plan(Params p, KernelBuffers buf) {
  uint s = group_index(p) * BLOCK + threadIdx.x;
  if (s >= buf.list_state[0].systems) return;
  ListSystem planned = list_planned(buf.list_system[s], buf.list_state[0]);
  buf.list_system[s] = planned;
  if (spans_too_much(planned)) buf.list_state[0].wide = 1u;
}

Entry list_plan_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_plan); }

}  // namespace spherepair
