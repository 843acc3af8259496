// SPDX-License-Identifier: MIT
// Buffer slots, block sizes and the parameter struct, as C++, CUDA and GLSL all see them.
#ifndef SPHEREPAIR_LAYOUT_H
#define SPHEREPAIR_LAYOUT_H

#include "portable.h"

// Buffers, by binding, for n spheres.
#define SLOT_POSITION 0  // vec4[n]: centre in metres, radius in w
#define SLOT_VELOCITY 1  // vec4[n]: metres per second, w unused
#define SLOT_COUNT 2     // uint[n]: contacts of each sphere; a sphere is coloured as colliding when its count is not 0
#define SLOT_SUMMARY 3   // uint[SUMMARY_SLOTS * SUMMARY_WORDS]: partial totals, see SUM_*
#define SLOT_DEFERRED 4  // uvec2[]: pairs (i<j) that the float32 filter leaves undecided; their number is SUM_DEFERRED
#define SLOT_PAIR 5      // uvec2[]: colliding pairs (i<j) in any order, when asked for; their number is SUM_LISTED
#define SLOT_SPHERES 6   // vec4[2m]: the m pairs of spheres that `decide` is asked about
#define SLOT_VERDICT 7   // uint[m]: what `decide` answers, verdict_code()
#define SLOT_TOTAL 8
#define SLOT_PARAMS 0  // the uniform block's own binding

// Totals are spread over SUMMARY_SLOTS rows so that thousands of groups do not queue on one address; the host adds the
// rows. 64-bit totals take two words, low first.
#define SUMMARY_SLOTS 64
#define SUMMARY_WORDS 16
#define SUM_PAIRS 0      // uint64: colliding pairs
#define SUM_MIX_A 2      // uint64: fingerprint, sum of pair_mix_a
#define SUM_MIX_B 4      // uint64: fingerprint, sum of pair_mix_b
#define SUM_COLLIDING 6  // uint: spheres whose count left 0
#define SUM_DEFERRED 8   // uint, row 0 only: pairs the filter left undecided
#define SUM_LISTED 9     // uint, row 0 only: pairs wanted by the list, also beyond its capacity
#define SUM_STAGE 10     // uint[5]: deferred pairs by the stage that decided them, STAGE_*

#define SPHERES_PER_THREAD 8  // rows that one thread of collide_triangle holds
#define COLUMNS_AT_ONCE 2     // columns that a thread of collide_triangle meets between two branches
#define NEAR_CAPACITY 1024    // near meetings that one group of collide_triangle can queue per tile
#define SERVICE_BLOCK 128     // group size of the kernels whose size is no subject of the study
#define MAX_GROUPS 65535      // of one dispatch along each axis, on every device; more are folded into the next axis

struct Params {
  float dt, gravity_dt, half_gravity_dt2, restitution;  // seconds, g*dt, g*dt*dt/2 (both <= 0 along y), 0..1
  float plane, radius, apart_above, collide_below;      // y of the plane; for equal radii: squared-distance bounds
  float filter_scale, filter_offset, spare_0, spare_1;  // K and T of filter_pair
  uint n, columns, pair_capacity, deferred_capacity;    // columns: spheres that one group of collide_triangle meets
  uint defer_undecided, pairs_to_decide, first_group, spare_2;  // 0: the naive predicate; of decide; of this slice
};

#ifndef GL_core_profile
static_assert(sizeof(Params) == 80 && alignof(vec4) == 16 && sizeof(uvec2) == 8);
#endif

#endif
