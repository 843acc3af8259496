// SPDX-License-Identifier: MIT
// Places in a list, for which the groups queue once each.
#include "shaders/draw/visible.glsl"

shared uint entries;  // of the group
shared uint first_entry;

// The place in the list whose entries `word` of SLOT_DRAWN counts, for a thread that takes one. All threads of the
// group call it.
uint index_in_list(uint word, bool takes) {
  if (gl_LocalInvocationID.x == 0u) entries = 0u;
  barrier();
  uint sorted_index = takes ? atomicAdd(entries, 1u) : 0u;
  barrier();
  if (gl_LocalInvocationID.x == 0u && entries > 0u) first_entry = atomicAdd(drawn[word], entries);
  barrier();
  return first_entry + sorted_index;
}
