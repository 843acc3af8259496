// SPDX-License-Identifier: MIT
// What a picture is taken of and how: the parameters of the kernels draw_*.
#ifndef SPHEREPAIR_VIEW_H
#define SPHEREPAIR_VIEW_H

#include "common/shared/portable.h"

#define VIEW_LOCATION 1  // of the uniforms that hold it, in fours of its words ...
#define VIEW_FOURS 13    // ... so many

#define WALK_AT_MOST 16   // pixels: a box no wider and no higher is walked by one thread, a larger one cut into tiles
#define LANES 32          // threads that share a sphere where spheres are few ...
#define LANES_ACROSS 8    // ... so many in a row of the sphere's box ...
#define SHARE_AT_MOST 64  // ... and then pixels, in place of WALK_AT_MOST
#define TILE 32u          // pixels: side of a tile of a large sphere's box
#define PASS_DEPTH 0      // two passes where there are no 64-bit atomics: first the depth ...
#define PASS_ID 1         // ... then, of the spheres at that depth, the lowest number
#define PASS_KEEP 2       // of draw_resolve: what the pixels show stays there for who asks

#define LIGHT_OCCLUSION 1u  // bits of View::lighting: spheres near the point take light from all around away,
#define LIGHT_SHADOW 2u     // any sphere on the way takes the sun's,
#define LIGHT_GROUND 4u     // and both show on the plane too
#define OCCLUSION_RADII 4   // so far, in largest radii, a sphere takes light away: less than two dense cells

#define CLUSTER 16           // spheres, in consecutive places, that are culled together
#define BUNDLE 4u            // clusters, one after the other, that are culled together first: a bundle
#define BOUNDS_LANES 4u      // threads that share a cluster when its box is made
#define SEEN_BLOCK 128       // threads, and spheres at a time, of a group that goes through a list of spheres ...
#define CLUSTERS_BLOCK 256   // ... or of clusters ...
#define WALKERS 8            // ... and the threads that then share a sphere ...
#define WALKERS_ACROSS 4     // ... so many in a row of its box
#define SEEN_FADES 1u        // in each picture, of the 15 that a sphere gets in the one that shows it
#define WALK_ALONE 8u        // pixels that a thread that finds them tries itself ...
#define WALK_UNTESTED 4u     // ... and so many that are as soon tried as looked up in the pyramid
#define PIXELS_EACH 4        // pixels of one thread that goes through the picture ...
#define PIXELS_BLOCK 256     // ... in groups of so many
#define PHASE_SEEN 0         // draws the spheres that the last pictures showed ...
#define PHASE_REST 1         // ... and then those of the others that what is drawn already does not hide, or first ...
#define PHASE_NEAR 2         // ... of these the ones that are not far behind what is drawn, and then ...
#define PHASE_FAR 3          // ... the others, which by then are hidden but for a few
#define PHASE_ALL 4          // in place of PHASE_REST: clusters are not tested before their spheres
#define NEAR_LAYERS 2.0f     // so far behind, in a cluster's thinnest half, is near
#define LEVEL_0 8            // pixels: side of what a texel of the pyramid's level 0 covers ...
#define LEVEL_1 32           // ... of its level 1 ...
#define LEVEL_2 128          // ... and of its level 2
#define PYRAMID_BLOCK 1024   // threads that make a texel of level 2 and those in it
#define TEXELS_AT_MOST 36    // in which a box is looked up at level 0, beside those that its borders touch
#define TEXELS_FEW 6         // the same for clusters where there are no bundles, of pictures ...
#define LARGE_IMAGE 262144u  // ... of so many pixels or more
#define TEXELS_TO_SEARCH 64  // at levels 1 and 2; a box of more is taken for seen

// The lists in SLOT_CLUSTER_LIST, each with room for all clusters.
#define LIST_DRAWN 0u     // clusters to draw at once
#define LIST_DEFERRED 1u  // those far behind what is drawn already, or parts of bundles: all_of_bundle
#define LIST_FAR 2u       // clusters of the latter that are to be drawn after all
#define HIDDEN 3u         // in none ...
#define OUT_OF_VIEW 4u    // ... of them

// Words of SLOT_DRAWN. Those from DRAWN_LARGE on are counted on request only.
#define DRAWN_TILES 0               // entries that the list of tiles needs
#define DRAWN_TILES_DONE 1          // of those, the ones of the first phase
#define DRAWN_CLUSTERS 2            // and 3, 4, by LIST_*: entries of the lists of clusters
#define DRAWN_SEEN 5                // and 6, by View::turn: entries of the two lists of spheres seen
#define DRAWN_LARGE 7               // spheres cut into tiles
#define DRAWN_SMALL 8               // spheres walked at once, with at least one pixel's centre in their box
#define DRAWN_UNSEEN 9              // spheres out of view, or between the centres of the pixels
#define DRAWN_UNDRAWABLE 10         // spheres whose numbers are beyond those that can be drawn, see in_camera
#define DRAWN_CLUSTERS_OUTSIDE 11   // clusters out of view
#define DRAWN_CLUSTERS_HIDDEN 12    // clusters behind what is drawn already
#define DRAWN_HIDDEN 13             // spheres behind what is drawn already, of clusters that are not
#define DRAWN_CLUSTERS_DEFERRED 14  // clusters that waited for others to be drawn
#define DRAWN_BUNDLES 15            // bundles left out or put off as a whole
#define DRAWN_WORDS 16
// Behind them the same of the picture before, once its pixels are cleared.

struct View {
  vec4 eye;                 // metres; w: least depth that is drawn
  vec4 right, up, forward;  // the camera's axes in the world, of length 1
  vec4 light;  // towards the light in the camera's axes, of length 1; w: the share of light from all around
  vec4 sun;    // the same in the world; w: the ground's brightness in full shadow, of the background's
  float focal, centre_x, centre_y, pixel;  // pixels per unit of x/z; where forward meets the image, pixels; 1 / focal
  float half_x, half_y, norm_x, norm_y;    // the widest |x/z| and |y/z| seen, rounded up; sqrt(1 + half^2), rounded up
  uvec4 palette_0, palette_4;              // 0xRRGGBB of 0, 1, 2, 3 contacts; of 4, 5, 6, 7 and more
  uint background, width, height, pass;    // 0xRRGGBB; pixels; PASS_*
  uint tile_capacity, counting, phase;     // entries; not 0: DRAWN_* are counted; PHASE_*
  uint occlusion;                          // not 0: what is hidden is passed over
  uint clusters, turn, lanes, lighting;    // their number; see DRAWN_SEEN; threads a sphere: 1 or LANES; LIGHT_*
};

#endif
