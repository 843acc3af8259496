// SPDX-License-Identifier: MIT
// Lists of pairs on a device: the structs of its kernels, and the cells in which they look for pairs. Points are
// wrapped into their system's box and binned into cells. A point looks through all cells within its reach, image by
// image. Rounding may add candidates but never loses one; list_exact.h decides on the numbers as given.
#ifndef SPHEREPAIR_LIST_H
#define SPHEREPAIR_LIST_H

#include "common/shared/layout.h"

#define LIST_BLOCK 128               // group size of list_count and list_find
#define LIST_THREADS 524288u         // these start at least so many threads, with up to 32 for a row of the list
#define LIST_KEPT_MOST 128u          // keys of a row that list_count keeps before the length of the list is known, ...
#define LIST_KEPT_TOTAL 33554432u    // ... keys of all rows, above which fewer of each are kept, ...
#define LIST_KEPT_LEAST 12u          // ... and keys of a row that are kept in any case
#define LIST_ORDER_BLOCK 64          // group size of list_order
#define LIST_ORDER_ROWS 32u          // rows, at most, that a group of list_order sorts; ...
#define LIST_ORDER_GROUPS 4096u      // ... fewer if there would be fewer groups than this
#define LIST_PREPARED 2048u          // points and queries, at most, of a system that one group of list_prepare prepares
#define LIST_PREPARE_BLOCK 128       // its group size
#define LIST_PREPARED_SYSTEMS 4096u  // systems, at most, for which list_prepare is launched
#define LIST_RANKED 64u              // keys, at most, of a row in which each key's place is found by counting
#define LIST_CHUNK_BITS 8u
#define LIST_CHUNK 256u  // keys that 32 threads sort in registers: 2^LIST_CHUNK_BITS
#define LIST_ROOM 1024u  // keys that a group of list_order has room for in shared memory
#define LIST_EACH 4u     // points and queries that a thread of list_measure measures
#define LIST_TILE 2048u  // rows that a group of list_sums and of list_scan adds up
#define LIST_ASKS 1u     // flags of ListState: queries look, not the points
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
  double origin[3], scale;      // a wrapped point x is binned at (x - origin) * scale
  double low[3], cells_per_unit[3], slack[3];  // of coordinates
  double reach;                                // of a point of radius 0
};

struct ListState {
  uint wrong, far;  // ~index of the first point that is not listed, or too far from its box
  uint wide;        // not 0: keys have no room for the images within reach
  uint kept;        // keys of a row that list_count has room for
  double cutoff, skin;
  int64_t room;                            // pairs that the columns have room for
  uint points, queries, looking, systems;  // queries stand behind the points; looking: all that look
  uint flags, exclusions;                  // LIST_*; pairs in SLOT_LIST_EXCLUDED
  uint row_bits, order_bits;               // 2^row_bits threads look for the pairs of a row; 2^order_bits rows a group
};

// What a point or a query looks through: a block of cells, of which those beyond the system's own are of images.
struct UNIFORM_ALIGN ListLook {
  vec4 place;                      // wrapped and scaled; w: its own part of the reach
  uint cell_x, cell_y, cell_z;     // the first cell, ...
  int image_x, image_y, image_z;   // ... its image, ...
  uint along_x, along_y, along_z;  // ... and the number of cells along each axis
  uint i, system;                  // its index in the list's rows
  uint self;                       // the binned index of a point; ~0 of a query
};

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

// Sets the numbers of cells: about two points a cell, each at least half a reach wide. x, y and z: the system's lengths
// in reaches.
FN ListSystem with_cells(ListSystem s, float x, float y, float z) {
  float points = float(s.end_point - s.first_point);
  EXACT float enough = points * 0.5f;
  EXACT float product = points + 1.0f;
  EXACT float side = 0.5f;
  for (uint turn = 0u; turn < 200u && product > enough; ++turn) {
    EXACT float cells_x = x / side;
    EXACT float cells_y = y / side;
    EXACT float cells_z = z / side;
    s.cells[0] = uint(larger(cells_x, 1.0f));
    s.cells[1] = uint(larger(cells_y, 1.0f));
    s.cells[2] = uint(larger(cells_z, 1.0f));
    product = float(s.cells[0]) * float(s.cells[1]) * float(s.cells[2]);
    if (s.cells[0] == 1u && s.cells[1] == 1u && s.cells[2] == 1u) return s;
    side = side * 1.25f;
  }
  return s;
}

FN bool is_periodic(ListSystem s, uint k) { return (s.periodic >> k & 1u) != 0u; }

FN double largest_reach(ListSystem s) {
  EXACT double reach = s.reach + bound_above(s.extreme[LIST_LOOKING_RADIUS]);
  return reach;
}

// Where the cells along axis k begin, how long it is, by how much coordinates may be off, and its length in reaches.
struct ListAxis {
  double low, extent, slack;
  float reaches;
};
FN ListAxis list_axis(ListSystem s, uint k) {
  double zero = bits_double(0u, 0u);
  double one = bits_double(0x3FF00000u, 0u);
  bool some = s.extreme[LIST_HIGH + k] != 0u;
  ListAxis axis;
  axis.low = is_periodic(s, k) || !some ? zero : bound_below(s.extreme[LIST_LOW + k]);
  EXACT double measured = bound_above(s.extreme[LIST_HIGH + k]) - axis.low;
  axis.extent = is_periodic(s, k) ? one : some ? measured : zero;
  EXACT double wide = largest_reach(s) * s.span[k];
  EXACT double ratio = axis.extent / wide;
  EXACT double most = wide * bits_double(0x41CDCD65u, 0u);  // 1e9 reaches
  axis.reaches = !(axis.extent > zero) ? 1.0f : axis.extent >= most ? 1.0e9f : float(ratio);
  EXACT double slack = bound_above(s.extreme[LIST_LARGEST]) * s.span[k] * bits_double((1023u - 46u) << 20, 0u) +
                       (is_periodic(s, k) ? bits_double(0x3EB0C6F8u, 0u) : zero);  // 1e-6
  axis.slack = slack;
  return axis;
}

// Upper bounds: of a wrapped point's coordinates and its reach; of the numbers that are added to move a point to an
// image.
FN double list_size(ListSystem s) {
  EXACT double largest = bits_double(0u, 0u);
  for (uint axis = 0u; axis < 3u; ++axis) {
    EXACT double along = bits_double(0u, 0u);
    for (uint k = 0u; k < 3u; ++k) along = along + list_axis(s, k).extent * magnitude(s.row.of[3u * k + axis]);
    if (along > largest) largest = along;
  }
  EXACT double size = largest + largest_reach(s);
  return size;
}
FN double list_added(ListSystem s) {
  EXACT double added = bound_above(s.extreme[LIST_LARGEST]);
  for (uint k = 0u; k < 3u; ++k) {
    EXACT double boxes =
        double(s.extreme[LIST_CELLS + k]) + largest_reach(s) * s.span[k] + bits_double(0x40000000u, 0u);
    if (is_periodic(s, k)) added = added + boxes * s.edge[k];
  }
  return added;
}

// Sets the images along each axis that a wrapped point of 0 <= coordinate <= 1 may reach, and the bits of their number.
FN ListSystem with_images(ListSystem s) {
  EXACT double all = bits_double(0x3FF00000u, 0u);
  for (uint k = 0u; k < 3u; ++k) {
    EXACT double span = largest_reach(s) * s.span[k] + list_axis(s, k).slack;
    uint images = span < bits_double(0x41300000u, 0u) ? uint(span) + 1u : 1048577u;  // 2^20
    s.images[k] = is_periodic(s, k) ? images : 0u;
    all = all * double(2u * s.images[k] + 1u);
  }
  s.key_bits = 0u;
  while (s.key_bits < 32u && double(1u << s.key_bits) < all) ++s.key_bits;
  return s;
}

// The cells of a system, from its extremes. With u = 2^-53: a coordinate, and a wrapped point's distance from another,
// are rounded by less than 64u of the numbers that are added, which 2^-46 of them covers. In float32 and scaled, five
// numbers are rounded along each axis: each is below 1 and off by 2^-25 at most, three of a query below 2 and off
// by 2^-24. That moves a distance by less than 2^-21. So near its reach c <= r a distance d is off by e at most, and
// d^2 - c^2 by less than e (2r + e). Squares and reaches are rounded seven times, each time by 2^-24 (r + e)^2 at most;
// 2^-20 (r + e)^2 covers twice as much.
FN ListSystem list_planned(ListSystem s, ListState state) {
  double zero = bits_double(0u, 0u);
  EXACT double reach = state.cutoff + state.skin + bound_above(s.extreme[LIST_RADIUS]);
  s.reach = reach;
  ListAxis x = list_axis(s, 0u);
  ListAxis y = list_axis(s, 1u);
  ListAxis z = list_axis(s, 2u);
  s = with_cells(s, x.reaches, y.reaches, z.reaches);
  s = with_images(s);
  double size = list_size(s);
  uint exponent = (double_high(size) >> 20) + 1u;  // of a power of two above the size
  s.scale = size > zero ? bits_double((2046u - exponent) << 20, 0u) : bits_double(0x3FF00000u, 0u);
  EXACT double rounded = list_added(s) * s.scale * bits_double((1023u - 46u) << 20, 0u);
  EXACT double error = rounded * bits_double(0x40200000u, 0u) + bits_double((1023u - 21u) << 20, 0u);
  EXACT double farthest = largest_reach(s) * s.scale + error;
  EXACT double tolerance = farthest * (error + error + farthest * bits_double((1023u - 20u) << 20, 0u));
  s.tolerance = float(tolerance);
  for (uint k = 0u; k < 3u; ++k) {
    ListAxis axis = list_axis(s, k);
    EXACT double per_unit = double(s.cells[k]) / axis.extent;
    s.low[k] = axis.low;
    s.slack[k] = axis.slack;
    s.cells_per_unit[k] = axis.extent > zero ? per_unit : zero;
    EXACT double origin = zero;
    for (uint open = 0u; open < 3u; ++open)
      if (!is_periodic(s, open)) origin = origin + list_axis(s, open).low * s.row.of[3u * open + k];
    s.origin[k] = origin;
  }
  return s;
}

// Whether the points of a system times the images within its reach are more than keys can number.
FN bool spans_too_much(ListSystem s) {
  if (s.key_bits > 31u) return true;
  EXACT double keys = double(s.end_point - s.first_point) * double(1u << s.key_bits);
  return keys > bits_double(0x41F00000u, 0u);  // 2^32
}

#endif
