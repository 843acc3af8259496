#version 450
// SPDX-License-Identifier: MIT
// One thread per SPHERES_PER_BOUNCER spheres: makes a step of the method `anchored`, which handles only the spheres
// that may reach the plane. A group compacts these into a list first, so that the few that bounce share subgroups
// instead of delaying one each.
#include "shaders/motion/motion_state.glsl"

layout(std430, binding = SLOT_NEXT_EVENT) readonly buffer NextEventVectors { uvec4 next_event_vector[]; };
layout(local_size_x = BLOCK) in;
shared uint found;
shared uint bouncing[SPHERES_PER_BOUNCER * BLOCK];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint first = group_index() * (SPHERES_PER_BOUNCER / 4) * BLOCK + lane;
  uint now = p.motion.whole_state == 0u ? motion_params().steps_done : NO_EVENT - 1u;
  if (lane == 0u) found = 0u;
  barrier();
  for (uint v = 0u; v < SPHERES_PER_BOUNCER / 4; ++v) {
    uint i = 4u * (first + v * BLOCK);
    if (i >= p.n) break;
    uvec4 event_step = next_event_vector[i / 4u];
    if (now >= event_step.x) bouncing[atomicAdd(found, 1u)] = i;
    if (now >= event_step.y && i + 1u < p.n) bouncing[atomicAdd(found, 1u)] = i + 1u;
    if (now >= event_step.z && i + 2u < p.n) bouncing[atomicAdd(found, 1u)] = i + 2u;
    if (now >= event_step.w && i + 3u < p.n) bouncing[atomicAdd(found, 1u)] = i + 3u;
  }
  barrier();
  for (uint k = lane; k < found; k += BLOCK) {
    uint i = bouncing[k];
    Anchor a = anchor_anew(load_anchor(i), motion_params());
    flight[i] = a.speed;
    flight[p.n + i] = a.age;
    since[i] = a.since;
    next_event[i] = next_event_step(a, motion_params());
  }
}
