// SPDX-License-Identifier: MIT
// Buffer slots, block sizes and parameter structs, shared by C++, CUDA and GLSL.
#ifndef SPHEREPAIR_LAYOUT_H
#define SPHEREPAIR_LAYOUT_H

#include "common/shared/portable.h"

// Buffers, numbered by binding, for n spheres.
#define SLOT_POSITION 0  // vec4[n]: centre in metres, radius in w
#define SLOT_VELOCITY 1  // vec4[n]: metres per second, w unused
#define SLOT_COUNT 2     // uint[n]: contacts of each sphere; if not 0 the sphere is coloured as colliding
#define SLOT_SUMMARY 3   // uint[SUMMARY_SLOTS * SUMMARY_WORDS]: partial totals, see SUM_*
#define SLOT_DEFERRED 4  // uvec2[]: SUM_DEFERRED undecided pairs of indices into the positions, for resolve_undecided
#define SLOT_PAIR 5      // uvec2[]: colliding pairs (i<j) in any order, if requested; SUM_LISTED of them
#define SLOT_SPHERES 6   // vec4[2m]: the m pairs of spheres that `decide` tests
#define SLOT_VERDICT 7   // uint[m]: results of `decide`, see verdict_code()
#define SLOT_CELL 8      // uint[cell_slots + 2]: sorted index at which each cell's spheres begin
#define SLOT_SPLIT_ID 9  // uint[n]: sphere index of each entry of SLOT_SPLIT, if not INDEX_IN_W
#define SLOT_SORTED 10   // vec4[n]: spheres in cell order; w: radius, or sphere index if INDEX_IN_W
#define SLOT_ID 11       // uint[n]: sphere index by sorted index, if INDEX_IN_ID
#define SLOT_SORTED_COUNT 12  // uint[n]: contacts by sorted index
#define SLOT_SCAN 13          // uint[scan_tiles]: tile sums for grid_scan; grid_bounds: [0] is 1 if out of order
#define SLOT_SPLIT 14         // vec4[n]: spheres sorted by bucket, globally or within each tile
#define SLOT_BUCKET 15        // uint[]: write cursor of each bucket; for tiles: see run_in_tile
#define SLOT_VISIBLE 16    // uint[2 * pixels], the visibility buffer: sphere index, then depth; both ~0 for background
#define SLOT_IMAGE 17      // uint[pixels]: red, green, blue, 255 from the lowest byte up; rows from the top
#define SLOT_TILE 18       // uvec2[]: large spheres cut into tiles: sphere index, index of the tile in its box
#define SLOT_DRAWN 19      // uint[2 * DRAWN_WORDS]: see view.h
#define SLOT_CLUSTER 20    // vec4[2 * (clusters + bundles)]: corners of the bounding boxes; w: list_for_bundle
#define SLOT_SEEN_LEFT 21  // uint[]: four bits a sphere, not 0 while the sphere is in SLOT_SEEN_LIST
#define SLOT_CLUSTER_LIST 22  // uint[3 * clusters], by LIST_*, each in any order
#define SLOT_PYRAMID 23       // uvec2[], the hierarchical Z: two depths a texel, level by level; see texel_of_pixel
#define SLOT_WIDE 24          // Real[6n], compensated and float64: all x, all y, all z, then velocities
#define SLOT_ANCHOR 25        // vec4[n], anchored: centres at the start, radius in w
#define SLOT_FLIGHT 26        // Real[2n], anchored: upward speeds at the anchors, then seconds from anchor to `since`
#define SLOT_SINCE 27         // uint[n], anchored: the step at which the anchor was made; see ANCHOR_ON_PLANE
#define SLOT_NEXT_EVENT 28    // uint[n], anchored: first step in which the sphere may reach the plane
#define SLOT_SEEN_LIST 29     // uint[], two by View::turn: indices of the spheres visible in recent frames
#define SLOT_VISIBLE_ODD 30   // as SLOT_VISIBLE, for every other frame if two are in flight
#define SLOT_COLOUR 31        // uint[n]: entry of the palette, unless contacts choose it; see View::colour_by
#define SLOT_AXIS 32          // three slots, Axis[n] each, leapfrog: the state along x, y and z
#define SLOT_IMPULSE 35       // three slots, int64[n] each, leapfrog: impulses of the step's contacts along x, y and z
#define SLOT_GROWN 38  // vec4[n]: spheres whose near pairs are listed: grown by a skin, or around paths; then images
#define SLOT_NEAR 39   // uvec2[]: their colliding pairs (i<j) in any order, SearchParams::near_pairs of them
#define SLOT_FAULT 40  // uint[FAULT_WORDS], leapfrog: the first sphere of each FAULT_*, or ~0; see skin.h
#define SLOT_ROW_LENGTH 41     // uint[looking], of lists of pairs: length of each row
#define SLOT_REST 42           // uint[n], leapfrog: what the last step did to each sphere; see contact_rest.h
#define SLOT_LIST_STATE 43     // ListState, of lists of pairs; see list.h
#define SLOT_LIST_SYSTEM 44    // ListSystem[systems]
#define SLOT_LIST_GIVEN 45     // dvec4[n]: points as given, then queries; radius in w
#define SLOT_LIST_PLACE 46     // ivec4[n]: boxes by which each was wrapped, and its system
#define SLOT_LIST_BEGIN 47     // int64[looking + 1]: begin of each row
#define SLOT_LIST_SUM 48       // uint64[tiles of rows]: their lengths
#define SLOT_LIST_FIRST 49     // uint[pairs], the columns: i, ...
#define SLOT_LIST_SECOND 50    // uint[pairs]: ... j, ...
#define SLOT_LIST_SHIFT 51     // int[3 * pairs]: ... and S
#define SLOT_LIST_LOOK 52      // ListLook[looking]: what each looks through
#define SLOT_LIST_EXCLUDED 53  // uvec2[]: pairs that are left out, sorted
#define SLOT_LIST_KEY 54       // uint[]: j and image of each pair, by rows in any order; see KeyRange in list_row
#define SLOT_LIST_BIN 55       // uvec2[points]: the cell of each, and its place there
#define SLOT_LIST_LONG 56      // uint[groups of rows]: groups of list_count with a row of more keys than it keeps
#define SLOT_IMAGE_OF 57       // uint[], contact_grow: the number of images of spheres, then the sphere of each
#define SLOT_TOTAL 58
#define SLOT_PARAMS 0     // the uniform block's own binding
#define STEPS_LOCATION 0  // location of GLSL's uniform with MotionParams::steps_done
#define CELL_TEXTURE 0    // texture units of GLSL, one per use, so that bindings seldom change
#define PYRAMID_TEXTURE 1
#define TEXTURE_UNITS 2

// Totals are spread over SUMMARY_SLOTS rows, so that thousands of groups do not contend for one address. The host adds
// the rows. 64-bit totals take two words, low first.
#define SUMMARY_SLOTS 64
#define SUMMARY_WORDS 16
#define SUM_PAIRS 0      // uint64: colliding pairs
#define SUM_MIX_A 2      // uint64: fingerprint, sum of pair_mix_a
#define SUM_MIX_B 4      // uint64: fingerprint, sum of pair_mix_b
#define SUM_COLLIDING 6  // uint64: spheres whose count is not 0; from `tally`
#define SUM_DEFERRED 8   // uint, row 0 only: pairs left to resolve_undecided, those beyond the list's capacity included
#define SUM_LISTED 9     // uint, row 0 only: pairs listed, those beyond the list's capacity included
#define SUM_STAGE 10     // uint[5]: undecided pairs by the stage that decided them, STAGE_*
#define SUM_UNDECIDED 15  // uint: pairs that the filter left undecided, in a search that decides most of them itself
#define TOTAL_ROWS 16     // rows of a group's partial totals in shared memory, so that threads contend less
#define TOTAL_STRIDE 9    // words from row to row: rows begin in different banks

#define SPHERES_PER_THREAD 8  // rows that one thread of collide_triangle holds in registers
#define COLUMNS_AT_ONCE 2     // columns that share a bit in the candidate masks of collide_triangle
#define NEVER_NEAR -3.0e38f   // initial gram_product of rows beyond the last sphere: near hardly any column
#define NEAR_PER_THREAD 2     // candidates of a tile that a group of collide_triangle can queue, per thread
#define SERVICE_BLOCK 128     // group size of kernels whose group size is not studied
#define MAX_GROUPS 65535      // along one axis of a dispatch, on every device; more are folded into the next axis

#define SPHERES_PER_SORTER 4       // spheres that one thread of grid_count and grid_scatter handles
#define SPHERES_PER_BOUNCER 8      // spheres that one thread of bounce checks
#define SPLIT_BLOCK 1024           // group size of split_tiles, split_count and grid_split
#define SORT_BLOCK 512             // group size of grid_sort
#define SPLIT_TILE 4096u           // spheres that one group of these kernels processes
#define SPLIT_EACH 4u              // spheres that one of its threads processes
#define SORT_EACH 3u               // spheres that one thread of grid_sort holds
#define BUCKETS_AT_MOST 1024u      // buckets that one group of grid_split handles in one pass
#define CELLS_PER_BUCKET 2048u     // upper limit; grid_sort has a counter for each cell
#define ROWS_AHEAD 5               // rows of cells in the later half of a neighbourhood
#define BOUNDS_TILE 512u           // spheres that one group of grid_bounds processes
#define BOUNDS_WINDOW 1024u        // cells whose begins grid_bounds keeps in shared memory at a time
#define ONE_PARENT 31u             // as parent_shift: all buckets have one parent
#define INDEX_IN_W 1u              // of a launch: sphere indices are in w instead of the radii, all equal, ...
#define INDEX_IN_ID 2u             // ... or in SLOT_ID; else they are positions in the buffer
#define EMPTY_CELLS_AT_MOST 4096u  // between two consecutive spheres in cell order
#define SCAN_BLOCK 256             // group size of grid_scan
#define SCAN_VECTORS 4             // uvec4 that one thread of grid_scan processes
#define SCAN_TILE 4096u            // entries of the table that one group of grid_scan processes
#define PEAK_CHAINS 8              // independent chains of multiply-adds in one thread of peak_issue, ...
#define PEAK_TURNS 64              // ... iterations of its loop, ...
#define PEAK_STEPS 16              // ... and steps of each chain in one iteration

#define MOTION_EULER 0u  // MotionMethod of motion_options.h
#define MOTION_SYMPLECTIC 1u
#define MOTION_PAPER 2u
#define MOTION_PAPER_CLAMP 3u
#define MOTION_IMPACT_LINEAR 4u
#define MOTION_IMPACT 5u
#define MOTION_ANCHORED 6u
#define MOTION_LEAPFROG 7u
#define PRECISION_FLOAT32 0  // Precision of motion_options.h
#define PRECISION_COMPENSATED 1
#define PRECISION_FLOAT64 2
#define PRECISION_FIXED 3
#define CONTACT_NONE 0u  // ContactLaw of contact_options.h
#define CONTACT_SPRING 1u
#define CONTACT_QUARTIC 2u
#define CONTACT_HERTZ 3u
#define FAULT_DEEP 0u   // errors of a step with contacts: a contact deeper than the smaller radius, ...
#define FAULT_FAST 1u   // ... a sphere that moves by more than the smallest radius, ...
#define FAULT_RANGE 2u  // ... or one beyond MOST_UNITS
#define FAULTS 3u
#define ANCHOR_ON_PLANE 0x80000000u  // bit of `since`: the anchor is a bounce, not the start
#define NO_EVENT 0xFFFFFFFFu

// A sphere's state in 64-bit integers along one axis: position and momentum, in the scene's units.
struct UNIFORM_ALIGN Axis {
  int64_t position, momentum;
};

// Parameters of kernels, one struct a component. std140 alignment: their sizes are multiples of 16 bytes.

// Constants of the motion are vec4 whose first three floats add up to the constant: see `constant` in real.h.
struct MotionParams {
  vec4 gravity_dt, half_gravity_dt2;                 // g*dt, g*dt*dt/2, both <= 0
  vec4 seconds_per_speed, zeno_flights;              // 2 / |g|, or 0 without gravity; flights until rest, see rebound
  float dt, gravity, steps_per_second, restitution;  // seconds, <= 0 along y, 1 / dt, 0..1
  float plane;                                       // y of the plane
  uint steps_done;                                   // anchored: number of steps after this move
  uint whole_state;    // not 0: evaluate_positions also writes velocities and SLOT_WIDE, bounce handles all with events
  uint clear_results;  // not 0: move and evaluate_positions clear contact counts and totals
};

// Parameters of contacts, see contact.h. Positions are 64-bit integers in units of 2^-unit_exponent metres.
struct UNIFORM_ALIGN ContactParams {
  int64_t low_x, low_y, low_z, high_x, high_y, high_z;  // walls, in units; far beyond MOST_UNITS for missing walls
  uint law;                                             // CONTACT_*
  int unit_exponent, reach_exponent;  // reach_exponent: 2^this is the power of two below the largest sum of two radii
  float impulse;                      // in a step, in units of momentum; lengths in 2^reach_exponent metres
  float damping;                      // per unit of closing speed and root of the reduced cubed radius
  float gravity;                      // impulse along y per cubic metre of cubed radius, <= 0
  float mobility;                     // units that a unit of momentum moves a sphere of 1 m radius in a step
  float metres_per_second;            // speed of one unit a step
  float fastest;                      // in units a step, see FAULT_FAST
  float skin;                         // by which a sphere is grown for the list of near pairs, in radii
  float drag_loss;                    // share of a momentum that drag takes in half a step
  uint sleeping;                      // SLEEP_* and TESTS_ALL_WALLS, see contact_rest.h
  // Corners of the periodic box, in metres; equal along axes that are not periodic. See periodic.h.
  vec4 box_low;   // w: what the box adds to centre_rounding, in metres
  vec4 box_high;  // w: how far a grown sphere reaches for images, beyond its own radius
};

struct UNIFORM_ALIGN SearchParams {
  float apart_above, collide_below;       // for equal radii: squared-distance bounds
  float filter_scale, filter_offset;      // K and T of filter_pair
  uint defer_undecided;                   // 0: the naive predicate
  uint columns_per_group;                 // spheres that a group of collide_triangle tests its rows against
  uint pair_capacity, deferred_capacity;  // of SLOT_PAIR and SLOT_DEFERRED
  uint near_pairs;                        // in SLOT_NEAR
  uint chunk;                             // consecutive spheres that a group of collide_grid takes, a power of two
  uint tiles_per_group;                   // for collide_tensor
};

struct UNIFORM_ALIGN GridParams {
  float origin_x, origin_y, origin_z, cells_per_metre;  // of the cells on level 0
  float largest_radius, reach_scale, reach_offset;      // on level 0, doubles with each level; see reach_in_cells
  float occlusion_fade;  // draw_light: 1 / (OCCLUSION_RADII * radius)^2 of equal radii; 0: radii differ
  uint cells_x, cells_y, cells_z, cell_slots;       // dense grid; cell_slots: length of the table, dense or hashed
  uint hash_mask, first_octave, top_level, levels;  // mask 0: dense; see level_of; levels: bit k: level k has spheres
};

struct UNIFORM_ALIGN SortParams {
  uint buckets, bucket_shift;       // the bucket of a slot is slot >> bucket_shift; 0 buckets: none
  uint parent_shift, first_bucket;  // see bucket_below; index into SLOT_BUCKET
  uint bucket_words;                // of SLOT_BUCKET, to be cleared
  uint scan_tiles;                  // of grid_scan
  uint index_in_w;                  // not 0: sorted spheres have their indices in w instead of the radii
  uint index_given;                 // not 0: a split reads spheres of an earlier split, with their indices
};

struct Params {
  MotionParams motion;
  SearchParams search;
  GridParams grid;
  SortParams sort;
  ContactParams contact;
  uint n;               // spheres; for `decide`, pairs of spheres
  float radius;         // of all spheres, if all are equal
  uint first_group;     // of this slice of the launch
  uint indices;         // CUDA: INDEX_* of the launch, see sphere_index; GLSL compiles it in
  uint waits_first;     // CUDA: not 0: the previous launch may still run; the kernel waits for it first
  uint image_capacity;  // of SLOT_IMAGE_OF: images of a periodic box
  uint unused_a, unused_b;
};

#ifndef GL_core_profile
static_assert(SPLIT_BLOCK == BUCKETS_AT_MOST && SPLIT_BLOCK * SPLIT_EACH == SPLIT_TILE);
static_assert(sizeof(MotionParams) == 96 && sizeof(SearchParams) == 48 && sizeof(GridParams) == 64 &&
              sizeof(SortParams) == 32 && sizeof(ContactParams) == 128 && sizeof(Params) == 400 && sizeof(uvec2) == 8 &&
              sizeof(Axis) == 16);
#endif

#endif
