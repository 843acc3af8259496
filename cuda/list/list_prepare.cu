// SPDX-License-Identifier: MIT
// One group per system of up to LIST_PREPARED points and queries: measures it, plans its cells, bins its points and
// writes what each looks through. For larger systems list_clear to list_look do so one after the other.
#include "common/shared/list_plan.h"
#include "cuda/list/list_extremes.cuh"
#include "cuda/list/list_place.cuh"

namespace spherepair {

__shared__ uint cell_begin[LIST_PREPARED / 4u];
__shared__ uint sums[LIST_PREPARE_BLOCK];

constexpr uint CELLS_EACH = LIST_PREPARED / 4u / uint(LIST_PREPARE_BLOCK);  // a cell has four points on average

// The k-th of the system's points, then queries.
__device__ inline uint element_at(const KernelBuffers& buf, uint s, uint k) {
  uint points = buf.list_system[s].end_point - buf.list_system[s].first_point;
  return k < points ? buf.list_system[s].first_point + k
                    : buf.list_state[0].points + buf.list_system[s].first_query + (k - points);
}

__device__ inline void plan(const KernelBuffers& buf, uint s) {
  uint lane = threadIdx.x;
  if (lane < LIST_EXTREMES) buf.list_system[s].extreme[lane] = extreme[lane];
  __syncthreads();
  if (lane == 0u) {
    ListSystem planned = list_planned(buf.list_system[s], buf.list_state[0]);
    buf.list_system[s] = planned;
    if (spans_too_much(planned)) buf.list_state[0].wide = 1u;
  }
  __syncthreads();
}

// Numbers of points become begins.
__device__ inline void sum_cells() {
  uint lane = threadIdx.x;
  uint own = 0u;
  for (uint c = lane * CELLS_EACH; c < (lane + 1u) * CELLS_EACH; ++c) own += cell_begin[c];
  uint upto = own;
  for (uint step = 1u; step < uint(LIST_PREPARE_BLOCK); step *= 2u) {
    sums[lane] = upto;
    __syncthreads();
    if (lane >= step) upto += sums[lane - step];
    __syncthreads();
  }
  uint begin = upto - own;
  for (uint c = lane * CELLS_EACH; c < (lane + 1u) * CELLS_EACH; ++c) {
    uint points = cell_begin[c];
    cell_begin[c] = begin;
    begin += points;
  }
  __syncthreads();
}

__global__ void __launch_bounds__(LIST_PREPARE_BLOCK) list_prepare(Params p, KernelBuffers buf) {
  uint lane = threadIdx.x;
  uint s = group_index(p);
  if (s >= buf.list_state[0].systems) return;
  uint first_point = buf.list_system[s].first_point;
  uint points = buf.list_system[s].end_point - first_point;
  uint elements = points + buf.list_system[s].end_query - buf.list_system[s].first_query;
  if (lane == 0u) group_system = s;
  if (lane < LIST_EXTREMES) extreme[lane] = 0u;
  for (uint c = lane; c < LIST_PREPARED / 4u; c += LIST_PREPARE_BLOCK) cell_begin[c] = 0u;
  __syncthreads();
  Extremes own = no_extremes();
  for (uint k = lane; k < elements; k += LIST_PREPARE_BLOCK) own = measured(buf, own, element_at(buf, s, k), s);
  add_up(own);
  __syncthreads();
  plan(buf, s);
  uint first_cell = buf.list_system[s].first_cell;
  for (uint k = lane; k < points; k += LIST_PREPARE_BLOCK) {
    uint c = cell_of(buf, first_point + k) - first_cell;
    buf.list_bins[first_point + k] = uvec2{c, atomicAdd(&cell_begin[c], 1u)};
  }
  __syncthreads();
  sum_cells();
  uint cells = buf.list_system[s].cells[0] * buf.list_system[s].cells[1] * buf.list_system[s].cells[2];
  for (uint c = lane; c < cells; c += LIST_PREPARE_BLOCK) buf.cell[first_cell + c] = first_point + cell_begin[c];
  if (lane == 0u) buf.cell[first_cell + cells] = first_point + points;
  bool asks = has_flag(buf, LIST_ASKS);
  for (uint k = lane; k < elements; k += LIST_PREPARE_BLOCK) {
    uint element = element_at(buf, s, k);
    vec4 place = place_of(buf, element);
    if (k >= points) {
      buf.sorted[element] = place;
      buf.list_look[element - buf.list_state[0].points] = look_of(buf, element - buf.list_state[0].points, element);
    } else {
      uvec2 bin = buf.list_bins[element];
      uint at = first_point + cell_begin[bin.x] + bin.y;
      buf.id[at] = element;
      buf.sorted[at] = place;
      if (!asks) buf.list_look[at] = look_of(buf, element, element);
    }
  }
}

Entry list_prepare_kernel(uint, Variant) { return reinterpret_cast<Entry>(&list_prepare); }

}  // namespace spherepair
