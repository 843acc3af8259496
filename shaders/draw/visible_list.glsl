// SPDX-License-Identifier: MIT
// Clears pixels for the next frame, PIXELS_EACH a thread, and lists the spheres that were visible in them.
#define VISIBLE_ACCESS  // nothing is drawn meanwhile
#include "shaders/draw/visibility_buffer.glsl"

shared uint found[BLOCK * PIXELS_EACH];
shared uint entries;  // of the group
shared uint first_entry;

// GLSL only from here: a word a pixel for 64-bit atomics, else two
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
// until here

// Whether the pixel's sphere is to be listed. Only pixels whose left and upper neighbours show another sphere, or are
// cleared already, test the bits of the sphere.
bool is_new(uint pixel) {
  uint sphere = seen_at(pixel).x;
  uint left = seen_at(max(pixel, 1u) - 1u).x;
  uint above = seen_at(max(pixel, v.width) - v.width).x;
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(seen_left[sphere / 8u], all) & all) == 0u;
}

// All threads of the group must call begin_list before and end_list after their pixels. View::turn chooses the list.
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
