// SPDX-License-Identifier: MIT
// The buffers of every kernel (layout.h says what they hold), and the index of a group whatever the fold and slice of
// its dispatch.
#extension GL_ARB_gpu_shader_int64 : require
#include "common/shared/layout.h"

layout(std140, binding = SLOT_PARAMS) uniform ParamsBlock { Params p; };
#ifndef ID_ACCESS
#define ID_ACCESS readonly
#endif
#ifndef POSITION_ACCESS
#define POSITION_ACCESS readonly
#endif
layout(std430, binding = SLOT_POSITION) restrict POSITION_ACCESS buffer PositionBuffer { vec4 position[]; };
layout(std430, binding = SLOT_VELOCITY) restrict buffer VelocityBuffer { vec4 velocity[]; };
layout(std430, binding = SLOT_COUNT) restrict buffer CountBuffer { uint count[]; };
layout(std430, binding = SLOT_SUMMARY) restrict buffer SummaryBuffer { uint summary[]; };
layout(std430, binding = SLOT_DEFERRED) restrict buffer DeferredBuffer { uvec2 deferred[]; };
layout(std430, binding = SLOT_PAIR) restrict buffer PairBuffer { uvec2 listed[]; };
layout(std430, binding = SLOT_ID) restrict ID_ACCESS buffer IdBuffer { uint id[]; };

#ifdef FOLDED
uint group_index() { return p.first_group + gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y; }
uint group_count() { return gl_NumWorkGroups.x * gl_NumWorkGroups.y; }
#else
uint group_index() { return gl_WorkGroupID.x; }
uint group_count() { return gl_NumWorkGroups.x; }
#endif

// Of whoever was found at a place of the launch's order: the number, and the sphere with its radius.
uint sphere_index(vec4 found, uint sorted_index) {
  if (INDICES == INDEX_IN_W) return float_bits(found.w);
  return INDICES == INDEX_IN_ID ? id[sorted_index] : sorted_index;
}
vec4 with_radius(vec4 found) {
  if (INDICES == INDEX_IN_W) found.w = p.radius;
  return found;
}

void clear_results(uint i) {
  if (i < p.n) count[i] = 0u;
  if (i < SUMMARY_SLOTS * SUMMARY_WORDS) summary[i] = 0u;
}
