// SPDX-License-Identifier: MIT
// Declares what every kernel uses: the buffers of layout.h, the index of its group, and the index of a sphere.
#extension GL_ARB_gpu_shader_int64 : require
#include "common/shared/layout.h"

layout(std140, binding = SLOT_PARAMS) uniform ParamsBlock { Params p; };
// GLSL only from here: a kernel has 16 buffers at most, used or not
#ifndef ONLY_GROUPS
// until here
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
// GLSL only from here: their end
#endif
// until here

// Return the index of this group and the number of groups, however the dispatch is folded and sliced.
#ifdef FOLDED  // GLSL only: the plain form saves the multiplication where the dispatch is neither folded nor sliced
uint group_index() { return p.first_group + gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y; }
uint group_count() { return gl_NumWorkGroups.x * gl_NumWorkGroups.y; }
// GLSL only from here: the plain form
#else
uint group_index() { return gl_WorkGroupID.x; }
uint group_count() { return gl_NumWorkGroups.x; }
#endif
// until here

// GLSL only from here: what uses these buffers
#ifndef ONLY_GROUPS
// until here
uint index_source() { return INDICES; }  // GLSL only: known to the compiler

// Return the index of a sphere found at index k of the launch's order, and the sphere with its radius. With INDEX_IN_W,
// w holds the index instead of the radius, whichever variant of a kernel reads it.
uint sphere_index(vec4 found, uint k) {
  if (index_source() == INDEX_IN_W) return float_bits(found.w);
  return index_source() == INDEX_IN_ID ? id[k] : k;
}
vec4 with_radius(vec4 found) {
  if (index_source() == INDEX_IN_W) found.w = p.radius;
  return found;
}

void clear_results(uint i) {
  if (i < p.n) count[i] = 0u;
  if (i < SUMMARY_SLOTS * SUMMARY_WORDS) summary[i] = 0u;
}
// GLSL only from here: their end
#endif
// until here
