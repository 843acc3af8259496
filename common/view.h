// SPDX-License-Identifier: MIT
// What a picture is taken of and how: the parameters of the kernels draw_*.
#ifndef SPHEREPAIR_VIEW_H
#define SPHEREPAIR_VIEW_H

#include "portable.h"

#define SLOT_VIEW 1  // the uniform block's binding

#define WALK_AT_MOST 16  // pixels: a box no wider and no higher is walked by one thread, a larger one cut into tiles
#define TILE 32          // pixels: side of a tile of a large sphere's box
#define PASS_DEPTH 0     // two passes where there are no 64-bit atomics: first the depth ...
#define PASS_ID 1        // ... then, of the spheres at that depth, the lowest number

// Words of SLOT_DRAWN. All but the first are counted on request only.
#define DRAWN_TILES 0       // entries that the list of tiles needs
#define DRAWN_LARGE 1       // spheres cut into tiles
#define DRAWN_SMALL 2       // spheres walked by one thread, with at least one pixel's centre in their box
#define DRAWN_UNSEEN 3      // spheres out of view, or between the centres of the pixels
#define DRAWN_UNDRAWABLE 4  // spheres whose numbers are beyond those that can be drawn, see in_camera
#define DRAWN_WORDS 8

struct View {
  vec4 eye;                 // metres; w: least depth that is drawn
  vec4 right, up, forward;  // the camera's axes in the world, of length 1
  vec4 light;  // towards the light in the camera's axes, of length 1; w: the share of light from all around
  float focal, centre_x, centre_y, pixel;  // pixels per unit of x/z; where forward meets the image, pixels; 1 / focal
  float half_x, half_y, norm_x, norm_y;    // the widest |x/z| and |y/z| seen, rounded up; sqrt(1 + half^2), rounded up
  uvec4 palette_0, palette_4;              // 0xRRGGBB of 0, 1, 2, 3 contacts; of 4, 5, 6, 7 and more
  uint background, width, height, pass;    // 0xRRGGBB; pixels; PASS_*
  uint tile_capacity, counting, spare_0, spare_1;  // entries; not 0: DRAWN_* are counted
};

#endif
