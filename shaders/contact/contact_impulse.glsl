// SPDX-License-Identifier: MIT
// Adds impulses to spheres in any order, and takes their sums.
#include "shaders/contact/contact_state.glsl"

// GLSL only from here: CUDA has the atomic
// Without 64-bit atomics, a sum is two words of 32 bits. It is exact once all additions are done, because exactly one
// of them sees each wrap of the low word.
#if defined ATOMICS_64
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { int64_t of[]; }
impulse[3];
int64_t load_from_impulse(uint k, uint i) { return impulse[k].of[i]; }
void clear_impulse(uint k, uint i, int64_t sum) {
  if (sum != 0l) impulse[k].of[i] = 0l;
}
void add_to_impulse(uint k, uint i, float value) { atomicAdd(impulse[k].of[i], integer_of(value)); }
#else
layout(std430, binding = SLOT_IMPULSE) buffer ImpulseBuffer { uvec2 of[]; }
impulse[3];
int64_t load_from_impulse(uint k, uint i) {
  uvec2 words = impulse[k].of[i];
  return int64_t(uint64_t(words.y) << 32 | uint64_t(words.x));
}
void clear_impulse(uint k, uint i, int64_t sum) {
  if (sum != 0l) impulse[k].of[i] = uvec2(0u);
}
void add_to_impulse(uint k, uint i, float rounded_here) {
  int64_t value = integer_of(rounded_here);
  uint low = uint(uint64_t(value) & 0xFFFFFFFFul);
  uint before = atomicAdd(impulse[k].of[i].x, low);
  uint high = uint(uint64_t(value) >> 32) + (before + low < before ? 1u : 0u);
  if (high != 0u) atomicAdd(impulse[k].of[i].y, high);
}
#endif
// until here

void add_impulse(uint i, float x, float y, float z) {
  add_to_impulse(0u, i, x);
  add_to_impulse(1u, i, y);
  add_to_impulse(2u, i, z);
}

// Returns the sum of the impulses that were added.
Push load_impulse(uint i) {
  return Push(load_from_impulse(0u, i), load_from_impulse(1u, i), load_from_impulse(2u, i), FAULTS);
}
// Sets that sum to 0 for the next step.
void clear_impulses(uint i, Push sum) {
  clear_impulse(0u, i, sum.x);
  clear_impulse(1u, i, sum.y);
  clear_impulse(2u, i, sum.z);
}
