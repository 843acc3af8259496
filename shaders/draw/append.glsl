// SPDX-License-Identifier: MIT
// Appends to a list in global memory, with one atomic per group.
#include "shaders/draw/visibility_buffer.glsl"

shared uint entries;  // of the group
shared uint first_entry;

// Returns the index of a new entry in the list whose length is in `word` of SLOT_DRAWN. Only threads with `appends` get
// one. All threads of the group must call it.
uint append_index(uint word, bool appends) {
  if (gl_LocalInvocationID.x == 0u) entries = 0u;
  barrier();
  uint own = appends ? atomicAdd(entries, 1u) : 0u;
  barrier();
  if (gl_LocalInvocationID.x == 0u && entries > 0u) first_entry = atomicAdd(drawn[word], entries);
  barrier();
  return first_entry + own;
}
