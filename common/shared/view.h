// SPDX-License-Identifier: MIT
// Camera, image and shading: parameters of the kernels draw_*.
#ifndef SPHEREPAIR_VIEW_H
#define SPHEREPAIR_VIEW_H

#include "common/shared/portable.h"

#define VIEW_LOCATION 1  // location of GLSL's uniforms for the View, which are uvec4 ...
#define VIEW_FOURS 16    // ... and this many

#define WALK_AT_MOST 16   // pixels: side of the largest box that one thread draws; larger ones are cut into tiles
#define LANES 32          // threads that share a sphere when spheres are few ...
#define LANES_ACROSS 8    // ... how many of them take a row of the sphere's box ...
#define SHARE_AT_MOST 64  // ... and the limit in pixels that replaces WALK_AT_MOST
#define TILE 32u          // pixels: side of a tile of a large sphere's box
#define PASS_DEPTH 0      // two passes without 64-bit atomics: first the depth ...
#define PASS_ID 1         // ... then the lowest index of the spheres at that depth
#define PASS_KEEP 2       // draw_resolve keeps the visibility buffer, for read-back

#define COLOUR_BY_CONTACTS 0u  // a sphere's colour depends on the number of its contacts,
#define COLOUR_BY_SPEED 1u     // on how many limits its speed has reached,
#define COLOUR_BY_RADIUS 2u    // on its radius,
#define COLOUR_BY_CLASS 3u     // or on the class that Drawing::set_classes gave it
#define COLOURS 8              // size of the palette

#define LIGHT_OCCLUSION 1u  // bits of View::lighting: ambient occlusion by near spheres,
#define LIGHT_SHADOW 2u     // shadows of the sun,
#define LIGHT_GROUND 4u     // and both on the ground too, ...
#define LIGHT_ALONE 8u      // ... and only the ground is drawn, darkened by the spheres
#define OCCLUSION_RADII 4   // range of ambient occlusion, in radii of the sphere: less than two cells of its level

#define CLUSTER 16            // consecutive spheres in cell order that are culled together
#define BUNDLE 4u             // consecutive clusters that are culled together first: a bundle
#define BOUNDS_LANES 4u       // threads that share a cluster when its box is computed
#define SEEN_BLOCK 128        // threads, and spheres at a time, of a group that draws a list of spheres ...
#define CLUSTERS_BLOCK 256    // ... or of clusters ...
#define BOX_THREADS 8         // ... and the threads that then share the box of a sphere ...
#define BOX_THREADS_ACROSS 4  // ... and how many of them take a row of it
#define SEEN_FADES 1u         // a sphere gets 15 when visible; each frame takes this off
#define PIXELS_ALONE 8u       // a box of at most this many pixels is drawn by the thread that sets it up ...
#define PIXELS_UNTESTED 4u    // ... and one of at most this many without a look into the hierarchical Z
#define PIXELS_EACH 4         // pixels a thread in passes over the image ...
#define PIXELS_BLOCK 256      // ... and the size of its groups
#define PHASE_SEEN 0          // draws the spheres that were visible in recent frames ...
#define PHASE_REST 1          // ... then the others that are not hidden by these, or first ...
#define PHASE_NEAR 2          // ... those that are not far behind the visible depths, and then ...
#define PHASE_FAR 3           // ... the deferred ones, most of which are hidden by then
#define PHASE_ALL 4           // instead of PHASE_REST: spheres are tested, not clusters
#define NEAR_LAYERS 2.0f      // how far behind is near, in smallest half extents of a cluster
#define LEVEL_0 8             // pixels: side of a texel of level 0 of the hierarchical Z ...
#define LEVEL_1 32            // ... of its level 1 ...
#define LEVEL_2 128           // ... and of its level 2
#define PYRAMID_BLOCK 1024    // threads that compute a texel of level 2 and those in it
#define TEXELS_AT_MOST 36     // texels of a box that is tested at level 0 at most, see texels_of
#define TEXELS_FEW 6          // the same for clusters without bundles, in images ...
#define LARGE_IMAGE 262144u   // ... of at least this many pixels
#define TEXELS_TO_SEARCH 64   // upper limit at levels 1 and 2; a larger box counts as visible

// Lists in SLOT_CLUSTER_LIST, each with room for all clusters.
#define LIST_DRAWN 0u     // clusters to draw at once
#define LIST_DEFERRED 1u  // clusters far behind the visible depths, or parts of bundles: all_of_bundle
#define LIST_FAR 2u       // deferred clusters that turn out to be visible
#define HIDDEN 3u         // behind what is drawn: in no list
#define OUT_OF_VIEW 4u    // outside the frustum: in no list

// Words of SLOT_DRAWN. The words from DRAWN_LARGE on are counted on request only.
#define DRAWN_TILES 0               // entries that the list of tiles needs
#define DRAWN_TILES_DONE 1          // of these, entries of the first phase
#define DRAWN_CLUSTERS 2            // and 3, 4, by LIST_*: entries of the lists of clusters
#define DRAWN_SEEN 5                // and 6, by View::turn: entries of the two lists of visible spheres
#define DRAWN_LARGE 7               // spheres cut into tiles
#define DRAWN_SMALL 8               // spheres drawn at once, with at least one pixel centre in their box
#define DRAWN_UNSEEN 9              // spheres outside the frustum, or between pixel centres
#define DRAWN_UNDRAWABLE 10         // spheres whose coordinates or radius cannot be drawn, see in_camera
#define DRAWN_CLUSTERS_OUTSIDE 11   // clusters outside the frustum
#define DRAWN_CLUSTERS_HIDDEN 12    // clusters culled by the hierarchical Z
#define DRAWN_HIDDEN 13             // spheres culled by the hierarchical Z, of clusters that were not
#define DRAWN_CLUSTERS_DEFERRED 14  // clusters deferred by occlusion culling
#define DRAWN_BUNDLES 15            // bundles culled or deferred as a whole
#define DRAWN_WORDS 16
// After these words come the same words of the previous frame, once its pixels are cleared.

struct View {
  vec4 eye;                 // metres; w: near plane
  vec4 right, up, forward;  // the camera's axes in the world, of length 1
  vec4 light;               // towards the light, unit vector in the camera's axes; w: share of ambient light
  vec4 sun;                 // the same in the world; w: ground's brightness in full shadow, relative to the background
  float focal, centre_x, centre_y, pixel;  // pixels per unit of x/z; where forward hits the image, pixels; 1 / focal
  float half_x, half_y, norm_x, norm_y;    // the widest |x/z| and |y/z| seen, rounded up; sqrt(1 + half^2), rounded up
  uvec4 palette_0, palette_4;              // 0xRRGGBB of 0, 1, 2, 3 contacts or limits; of 4, 5, 6, 7 and more
  uint background, width, height, pass;    // 0xRRGGBB; pixels; PASS_*
  uint tile_capacity, counting, phase;     // entries; not 0: DRAWN_* are counted; PHASE_*
  uint occlusion;                          // not 0: occlusion culling
  uint clusters, turn, lanes, lighting;    // number of clusters; see DRAWN_SEEN; threads a sphere: 1 or LANES; LIGHT_*
  vec4 limits_0;                           // ascending, in metres, or in m^2/s^2: squares of speeds ...
  float limit_4, limit_5, limit_6;         // ... of which the sphere's value reaches none to all
  uint colour_by;                          // COLOUR_BY_*
  vec4 ground;                             // its unit normal; w: its height along that, metres
};

#endif
