// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: shades the visible sphere or the background. Clears the visibility buffer for the
// next frame, unless it is to be kept.
#include "cuda/draw/visible_list.cuh"

namespace spherepair {

// Moves a count to the previous frame's, unless it counts the visible spheres that the next frame draws.
__device__ inline void move_counts(const KernelBuffers& buf, const View& v, uint word) {
  uint stays = DRAWN_SEEN + (v.occlusion != 0u ? 1u - v.turn : v.turn);
  if (word >= DRAWN_WORDS || word == stays) return;
  buf.drawn[DRAWN_WORDS + word] = buf.drawn[word];
  buf.drawn[word] = 0u;
}

__global__ void __launch_bounds__(BLOCK) draw_resolve(Params p, KernelBuffers buf, View v) {
  bool clears = v.pass != PASS_KEEP;
  uint lane = threadIdx.x;
  if (clears && group_index(p) == 0u) move_counts(buf, v, lane);
  bool lists = clears && v.occlusion != 0u;
  if (lists) begin_list();
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * BLOCK + lane;
    if (pixel >= v.width * v.height) break;
    uvec2 seen = seen_at(buf, pixel);
    uint colour = lit(v.background, 1.0f);
    if (seen.y != 0xFFFFFFFFu) {
      Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
      colour = shade(in_camera(buf.position[seen.x], v), ray, bits_float(seen.y), buf.count[seen.x], v);
    }
    buf.image[pixel] = colour;
    if (clears && seen.y != 0xFFFFFFFFu) clear_pixel(buf, v, pixel);
  }
  if (lists) end_list(p, buf, 1u - v.turn);
}

Entry draw_resolve_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_resolve); }

}  // namespace spherepair
