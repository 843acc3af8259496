// SPDX-License-Identifier: MIT
// Lists of pairs on a device: the structs of its kernels, and the cells in which they look for pairs. Points are
// wrapped into their system's box and binned into cells. A point looks through all cells within its reach, image by
// image. Rounding may add candidates but never loses one; list_exact.h decides on the numbers as given.
#ifndef SPHEREPAIR_LIST_H
#define SPHEREPAIR_LIST_H

#include "common/shared/layout.h"

#define LIST_BLOCK 128               // group size of list_count and list_find; half of it for LIST_ROWS rows
#define LIST_ROWS 32u                // rows, at most, for which a group looks; as few as there are groups ...
#define LIST_ROW_GROUPS 2048u        // ... up to this number
#define LIST_LONG_GROUPS 2048u       // groups, at most, of list_find
#define LIST_NEAR 8                  // cells, at most, along each axis, from where the first row's reach begins
#define LIST_FEW 2.0f                // points in a cube as long as the reach, below which rows look alone
#define LIST_RANGES 32u              // ranges of cells that a group looks through at a time
#define LIST_NO_RANGE 0xFFFFFFFFu    // points that are staged come from several
#define LIST_BOUNDS 13u              // of the rows that look together: 6 of cells, 6 of places, the reach
#define LIST_KEPT_MOST 128u          // keys of a row that list_count keeps before the length of the list is known, ...
#define LIST_KEPT_TOTAL 33554432u    // ... keys of all rows, above which fewer of each are kept, ...
#define LIST_KEPT_LEAST 12u          // ... and keys of a row that are kept in any case
#define LIST_LONG 128u               // pairs of a row, on average, from which on a group writes their keys together
#define LIST_ORDER_BLOCK 64          // group size of list_order
#define LIST_ORDER_GROUPS 4096u      // a group sorts up to 64 rows, as few as there are groups up to this number
#define LIST_PREPARED 2048u          // points and queries, at most, of a system that one group of list_prepare prepares
#define LIST_PREPARE_BLOCK 128       // its group size
#define LIST_PREPARED_SYSTEMS 4096u  // systems, at most, for which list_prepare is launched
#define LIST_EACH_BITS 4u
#define LIST_KEYS_EACH 16u   // keys that a thread of list_order sorts: 2^LIST_EACH_BITS
#define LIST_SLOT 17u        // words of shared memory for them; one stays free, against bank conflicts
#define LIST_WRITES 4u       // pairs that a thread writes at a time
#define LIST_MOST_BITS 5u    // up to 2^LIST_MOST_BITS threads sort a row at once, ...
#define LIST_MOST_KEYS 512u  // ... so many keys
#define LIST_EACH 4u         // points and queries that a thread of list_measure measures
#define LIST_TILE 2048u      // rows that a group of list_sums and of list_scan adds up
#define LIST_ASKS 1u         // flags of ListState: queries look, not the points
#define LIST_HALF 2u
#define LIST_INCLUSIVE 4u
#define LIST_SELF_PAIRS 8u
#define LIST_WANTS_FIRST 16u  // columns that are written
#define LIST_WANTS_SECOND 32u
#define LIST_WANTS_SHIFTS 64u
#define LIST_LOW 0  // extremes of a system: coordinates of its points, three each, ...
#define LIST_HIGH 3
#define LIST_CELLS 6            // ... boxes by which its points and queries were wrapped, ...
#define LIST_LARGEST 9          // ... the size of their coordinates as given, ...
#define LIST_RADIUS 10          // ... the radii of points ...
#define LIST_LOOKING_RADIUS 11  // ... and of those that look
#define LIST_EXTREMES 12u

// A vector for each axis of a box.
struct ListRows {
  double of[9];
};

struct ListSystem {
  ListRows row;             // H; a unit vector perpendicular to H where the box is not periodic
  ListRows dual;            // coordinate k of x is dual_k . x, in boxes or, where not periodic, lengths
  double edge[3], span[3];  // sizes of rows and of duals
  uint periodic;            // bit k: axis k is
  uint first_point, end_point, first_query, end_query, first_cell;
  uint extreme[LIST_EXTREMES];  // of list_measure, see ordered_high; of the low ones the complement
  uint cells[3];                // from here: of list_plan
  float tolerance;              // of a squared distance less the squared reach, in scaled units and float32
  uint images[3], key_bits;     // images within reach to either side; bits of a key that number an image
  double origin[3], scale;      // a wrapped point x lies at (x - origin) * scale
  double low[3], cells_per_unit[3], slack[3];  // of coordinates
  double reach;                                // of a point of radius 0
  float reach_part;                            // cutoff and skin, scaled
  uint looks_alone;                            // not 0: its rows do not look together
};

struct ListState {
  uint wrong, far;  // ~index of the first point that is not listed, or too far from its box
  uint wide;        // not 0: keys have no room for the images within reach
  uint longer;      // groups in SLOT_LIST_LONG
  uint kept;        // keys of a row that list_count has room for
  uint unused;
  double cutoff, skin;
  int64_t room;                            // pairs that the columns have room for
  uint points, queries, looking, systems;  // queries stand behind the points; looking: all that look
  uint flags, exclusions;                  // LIST_*; pairs in SLOT_LIST_EXCLUDED
  uint row_bits, order_bits;               // groups look for 2^row_bits rows, and sort 2^order_bits
};

// What a point or a query looks through: cells low to high - 1 along each axis, of which those beyond the system's own
// are of images.
struct UNIFORM_ALIGN ListLook {
  int low[3], high[3];  // high <= low: nothing
  uint i, system;       // its index in the list's rows
};

// Order-preserving code of a number, and back.
FN int ordered_code(float x) {
  int bits = int(float_bits(x));
  return bits < 0 ? bits ^ 0x7FFFFFFF : bits;
}
FN float number_of_code(int code) { return bits_float(uint(code < 0 ? code ^ 0x7FFFFFFF : code)); }

// A squared distance less the squared reach, in float32. It grows with the size of x, y and z.
FN float list_beyond(float x, float y, float z, float reach) {
  EXACT float in_plane = multiply_add(x, x, y * y);
  EXACT float squared = multiply_add(z, z, in_plane);
  EXACT float beyond = multiply_add(reach, -reach, squared);
  return beyond;
}

// Order-preserving code of a number's upper 32 bits, for atomic maxima; 0 stands for none.
FN uint ordered_high(double x) {
  uint high = double_high(x);
  return (high & 0x80000000u) != 0u ? ~high : high | 0x80000000u;
}
FN double number_of(uint ordered) {
  return bits_double((ordered & 0x80000000u) != 0u ? ordered & 0x7FFFFFFFu : ~ordered, 0u);
}
FN double bound_above(uint ordered) { return ordered == 0u ? bits_double(0u, 0u) : number_of(ordered + 1u); }
FN double bound_below(uint complement) { return number_of(~complement - 1u); }

FN double component_of(dvec4 x, uint axis) { return axis == 0u ? x.x : axis == 1u ? x.y : x.z; }
FN double magnitude(double x) { return x < bits_double(0u, 0u) ? -x : x; }

// Whether a number is 0 or from 2^-450 to 2^450 in size.
FN bool is_listed_number(double x) {
  uint high = double_high(x) & 0x7FFFFFFFu;
  uint low = double_low(x);
  if ((high | low) == 0u) return true;
  return high >= (1023u - 450u) << 20 && (high < (1023u + 450u) << 20 || (high == (1023u + 450u) << 20 && low == 0u));
}

FN double list_coordinate(ListRows dual, uint k, dvec4 x) {
  EXACT double at = dual.of[3u * k] * x.x + dual.of[3u * k + 1u] * x.y + dual.of[3u * k + 2u] * x.z;
  return at;
}

#endif
