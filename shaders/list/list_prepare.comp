#version 450
// SPDX-License-Identifier: MIT
// One group per system of up to LIST_PREPARED points and queries: measures it, plans its cells, bins its points and
// writes what each looks through. For larger systems list_clear to list_look do so one after the other.
// GLSL only from here: NVIDIA's OpenGL passes no member of a coherent buffer to a function
#ifdef VULKAN
#define LIST_ACCESS coherent
#endif
// until here
#include "shaders/list/list_extremes.glsl"
#include "shaders/list/list_place.glsl"
#include "common/shared/list_plan.h"

layout(std430, binding = SLOT_CELL) restrict writeonly buffer CellBuffer { uint cell[]; };
layout(std430, binding = SLOT_LIST_BIN) restrict buffer ListBinBuffer { uvec2 list_bins[]; };
layout(std430, binding = SLOT_ID) restrict writeonly buffer IdBuffer { uint id[]; };
layout(std430, binding = SLOT_SORTED) restrict writeonly buffer SortedBuffer { vec4 sorted[]; };
layout(std430, binding = SLOT_LIST_LOOK) restrict writeonly buffer ListLookBuffer { ListLook list_look[]; };
layout(local_size_x = LIST_PREPARE_BLOCK) in;

const uint CELLS_EACH = LIST_PREPARED / 4u / uint(LIST_PREPARE_BLOCK);  // a cell has four points on average

shared uint cell_begin[LIST_PREPARED / 4u];
shared uint sums[LIST_PREPARE_BLOCK];

// The k-th of the system's points, then queries.
uint element_at(uint s, uint k) {
  uint points = list_system[s].end_point - list_system[s].first_point;
  return k < points ? list_system[s].first_point + k : list_state[0].points + list_system[s].first_query + (k - points);
}

void plan(uint s) {
  uint lane = gl_LocalInvocationID.x;
  if (lane < LIST_EXTREMES) list_system[s].extreme[lane] = extreme[lane];
  memoryBarrierBuffer();  // GLSL only: barrier() orders shared memory alone
  barrier();
  if (lane == 0u) {
    ListSystem planned = list_planned(list_system[s], list_state[0]);
    list_system[s] = planned;
    if (spans_too_much(planned)) list_state[0].wide = 1u;
  }
  memoryBarrierBuffer();  // GLSL only: barrier() orders shared memory alone
  barrier();
}

// Numbers of points become begins.
void sum_cells() {
  uint lane = gl_LocalInvocationID.x;
  uint own = 0u;
  for (uint c = lane * CELLS_EACH; c < (lane + 1u) * CELLS_EACH; ++c) own += cell_begin[c];
  uint upto = own;
  for (uint step = 1u; step < uint(LIST_PREPARE_BLOCK); step *= 2u) {
    sums[lane] = upto;
    barrier();
    if (lane >= step) upto += sums[lane - step];
    barrier();
  }
  uint begin = upto - own;
  for (uint c = lane * CELLS_EACH; c < (lane + 1u) * CELLS_EACH; ++c) {
    uint points = cell_begin[c];
    cell_begin[c] = begin;
    begin += points;
  }
  barrier();
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint s = group_index();
  if (s >= list_state[0].systems) return;
  uint first_point = list_system[s].first_point;
  uint points = list_system[s].end_point - first_point;
  uint elements = points + list_system[s].end_query - list_system[s].first_query;
  if (lane == 0u) group_system = s;
  if (lane < LIST_EXTREMES) extreme[lane] = 0u;
  for (uint c = lane; c < LIST_PREPARED / 4u; c += LIST_PREPARE_BLOCK) cell_begin[c] = 0u;
  barrier();
  Extremes own = no_extremes();
  for (uint k = lane; k < elements; k += LIST_PREPARE_BLOCK) own = measured(own, element_at(s, k), s);
  add_up(own);
  barrier();
  plan(s);
  uint first_cell = list_system[s].first_cell;
  for (uint k = lane; k < points; k += LIST_PREPARE_BLOCK) {
    uint c = cell_of(first_point + k) - first_cell;
    list_bins[first_point + k] = uvec2(c, atomicAdd(cell_begin[c], 1u));
  }
  barrier();
  sum_cells();
  uint cells = list_system[s].cells[0] * list_system[s].cells[1] * list_system[s].cells[2];
  for (uint c = lane; c < cells; c += LIST_PREPARE_BLOCK) cell[first_cell + c] = first_point + cell_begin[c];
  if (lane == 0u) cell[first_cell + cells] = first_point + points;
  bool asks = has_flag(LIST_ASKS);
  for (uint k = lane; k < elements; k += LIST_PREPARE_BLOCK) {
    uint element = element_at(s, k);
    vec4 place = place_of(element);
    if (k >= points) {
      sorted[element] = place;
      list_look[element - list_state[0].points] = look_of(element - list_state[0].points, element);
    } else {
      uvec2 bin = list_bins[element];
      uint at = first_point + cell_begin[bin.x] + bin.y;
      id[at] = element;
      sorted[at] = place;
      if (!asks) list_look[at] = look_of(element, element);
    }
  }
}
