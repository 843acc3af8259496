#version 450
// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: no sphere is seen there yet. Those that the last picture showed are listed.
#include "visible.glsl"

layout(local_size_x = BLOCK) in;
shared uint found[BLOCK * PIXELS_EACH];
shared uint entries;  // of the group
shared uint first_entry;

#ifdef ATOMICS_64
uint sphere_at(uint pixel) { return uint(visible[pixel]); }
void clear_at(uint pixel) { visible[pixel] = 0xFFFFFFFFFFFFFFFFul; }
#else
uint sphere_at(uint pixel) { return visible[2u * pixel]; }
void clear_at(uint pixel) {
  visible[2u * pixel] = 0xFFFFFFFFu;
  visible[2u * pixel + 1u] = 0xFFFFFFFFu;
}
#endif

// Only the first of a sphere's pixels need to ask: one whose neighbours, unless they are cleared already, show another.
bool is_new(uint pixel) {
  uint sphere = sphere_at(pixel);
  uint left = sphere_at(max(pixel, 1u) - 1u);
  uint above = sphere_at(max(pixel, v.width) - v.width);
  if (sphere == 0xFFFFFFFFu || (pixel >= 1u && left == sphere)) return false;
  if (pixel >= v.width && above == sphere) return false;
  uint all = 15u << shift_in_word(sphere);
  return (atomicOr(seen_left[sphere / 8u], all) & all) == 0u;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  if (group_index() == 0u && lane < DRAWN_WORDS && lane != DRAWN_SEEN + v.turn) drawn[lane] = 0u;
  if (lane == 0u) entries = 0u;
  barrier();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index() * PIXELS_EACH + k) * BLOCK + lane;
    if (pixel >= v.width * v.height) break;
    if (v.occlusion != 0u && is_new(pixel)) {
      found[atomicAdd(entries, 1u)] = sphere_at(pixel);
    }
    clear_at(pixel);
  }
  barrier();
  if (lane == 0u && entries > 0u) first_entry = atomicAdd(drawn[DRAWN_SEEN + v.turn], entries);
  barrier();
  if (entries == 0u) return;
  uint first = first_seen(v.turn) + first_entry;
  for (uint k = lane; k < entries; k += BLOCK) seen_list[first + k] = found[k];
}
