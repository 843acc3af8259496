// SPDX-License-Identifier: MIT
// One thread per PIXELS_EACH pixels: the light on the sphere that is seen there, or the background. The pixels are
// cleared for the next picture, unless they are to be kept.
#include "cuda/draw/shown.cuh"

namespace spherepair {

// Counts begin anew, but of the list of spheres seen that the next picture draws.
__device__ inline void move_counts(const KernelBuffers& w, const View& v, uint word) {
  uint stays = DRAWN_SEEN + (v.occlusion != 0u ? 1u - v.turn : v.turn);
  if (word >= DRAWN_WORDS || word == stays) return;
  w.drawn[DRAWN_WORDS + word] = w.drawn[word];
  w.drawn[word] = 0u;
}

__global__ void __launch_bounds__(PIXELS_BLOCK) draw_resolve(Params p, KernelBuffers w, View v) {
  bool clears = v.pass != PASS_KEEP;
  uint lane = threadIdx.x;
  if (clears && group_index(p) == 0u) move_counts(w, v, lane);
  bool lists = clears && v.occlusion != 0u;
  Shown shown = lists ? begin_list() : Shown{};
  for (uint k = 0u; k < PIXELS_EACH; ++k) {
    uint pixel = (group_index(p) * PIXELS_EACH + k) * PIXELS_BLOCK + lane;
    if (pixel >= v.width * v.height) break;
    uvec2 seen = w.visible[pixel];
    uint colour = lit(v.background, 1.0f);
    if (seen.y != 0xFFFFFFFFu) {
      Ray ray = ray_through(pixel % v.width, pixel / v.width, v);
      colour = shade(in_camera(w.position[seen.x], v), ray, bits_float(seen.y), w.count[seen.x], v);
    }
    w.image[pixel] = colour;
    if (clears && seen.y != 0xFFFFFFFFu) clear_pixel(w, v, shown, pixel);
  }
  if (lists) end_list(p, w, shown, 1u - v.turn);
}

Entry draw_resolve_kernel(uint, Variant) { return reinterpret_cast<Entry>(&draw_resolve); }

}  // namespace spherepair
