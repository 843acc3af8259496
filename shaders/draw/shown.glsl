// SPDX-License-Identifier: MIT
// Pixels are cleared for the next picture, PIXELS_EACH a thread, and the spheres that they showed are listed for it.
#define VISIBLE_ACCESS  // nobody draws meanwhile
#include "shaders/draw/visible.glsl"

shared uint found[BLOCK * PIXELS_EACH];
shared uint entries;  // of the group
shared uint first_entry;

#ifdef ATOMICS_64
uvec2 seen_at(uint pixel) { return uvec2(uint(visible[pixel]), uint(visible[pixel] >> 32)); }
void clear_at(uint pixel) { visible[pixel] = 0xFFFFFFFFFFFFFFFFul; }
#else
uvec2 seen_at(uint pixel) { return uvec2(visible[2u * pixel], visible[2u * pixel + 1u]); }
void clear_at(uint pixel) {
  visible[2u * pixel] = 0xFFFFFFFFu;
  visible[2u * pixel + 1u] = 0xFFFFFFFFu;
}
#endif

// Only the first of a sphere's pixels need to ask: one whose neighbours, unless they are cleared already, show another.
bool is_new(uint pixel) {
  uint sphere = seen_at(pixel).x;
  uint left = seen_at(max(pixel, 1u) - 1u).x;
  uint above = seen_at(max(pixel, v.width) - v.width).x;
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(seen_left[sphere / 8u], all) & all) == 0u;
}

// All threads of the group call it before and after their pixels; the list is that of a View::turn.
void begin_list() {
  if (gl_LocalInvocationID.x == 0u) entries = 0u;
  barrier();
}
void clear_pixel(uint pixel) {
  if (v.occlusion != 0u && is_new(pixel)) found[atomicAdd(entries, 1u)] = seen_at(pixel).x;
  clear_at(pixel);
}
void end_list(uint turn) {
  uint lane = gl_LocalInvocationID.x;
  barrier();
  if (lane == 0u && entries > 0u) first_entry = atomicAdd(drawn[DRAWN_SEEN + turn], entries);
  barrier();
  if (entries == 0u) return;
  uint first = first_seen(turn) + first_entry;
  for (uint k = lane; k < entries; k += BLOCK) seen_list[first + k] = found[k];
}
