// SPDX-License-Identifier: MIT
// What every kernel gets, and where the host finds the kernels: one entry per file, by group size and variant.
#pragma once

#include "common/device/kernel_list.h"
#include "common/device/variant.h"
#include "common/shared/layout.h"

namespace spherepair {

struct AxisBuffer {
  Axis* of;
};

// The buffers of layout.h, by slot.
struct KernelBuffers {
  vec4* position;
  vec4* velocity;
  uint* count;
  uint* summary;
  uvec2* deferred;
  uvec2* listed;
  const vec4* spheres;
  uint* verdict;
  uint* cell;
  const uint* from_id;
  vec4* sorted;
  uint* id;
  uint* sorted_count;
  uint* tile_sum;
  uint* bucket_cursor;
  uvec2* visible;
  uint* image;
  uvec2* tile;
  uint* drawn;
  vec4* cluster;
  uint* seen_left;
  uint* cluster_list;
  uvec2* pyramid;
  void* wide;  // Real[]
  const vec4* anchor;
  void* flight;  // Real[]
  uint* since;
  uint* next_event;
  uint* rest;
  uint* seen_list;
  uint* colour;
  uint* fault;
  vec4* grown;
  const uvec2* near;
  uint* row;
  uint* row_length;
  AxisBuffer axis[3];
  int64_t* impulse[3];
};

// Every kernel is void (Params p, KernelBuffers buf); those that draw also take a View v. A null entry means a group
// size or a variant that was not compiled; a kernel of one form ignores both.
using Entry = const void*;
#define DECLARE(name) Entry name##_kernel(uint block, Variant variant);
SPHEREPAIR_KERNELS(DECLARE)
#undef DECLARE

}  // namespace spherepair
