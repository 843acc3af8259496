// SPDX-License-Identifier: MIT
// Lists of pairs on a device: the cells of a system, its images, and the tolerance of float32, from its extremes.
#ifndef SPHEREPAIR_LIST_PLAN_H
#define SPHEREPAIR_LIST_PLAN_H

#include "common/shared/list.h"

// Sets the numbers of cells: about four points a cell, or two in large systems whose rows look alone. Each is at least
// half a reach wide along y and z, and a quarter of that along x, so that the cells of one group's rows make a short
// rod. x, y and z: the system's lengths in reaches.
FN ListSystem with_cells(ListSystem s, bool asks, float x, float y, float z) {
  float points = float(s.end_point - s.first_point);
  EXACT float few = LIST_FEW * x * y * z;
  s.looks_alone = asks || points < few ? 1u : 0u;
  float a_point = s.looks_alone != 0u && s.end_point - s.first_point > LIST_PREPARED ? 0.5f : 0.25f;
  EXACT float enough = points * a_point;
  EXACT float product = points + 1.0f;
  EXACT float side = 0.5f;
  for (uint turn = 0u; turn < 200u && product > enough; ++turn) {
    EXACT float cells_x = x * 4.0f / side;
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
  EXACT double most = wide * bits_double(0x41ADCD65u, 0u);  // 2.5e8 reaches: eighths of them have 32 bits
  axis.reaches = !(axis.extent > zero) ? 1.0f : axis.extent >= most ? 2.5e8f : float(ratio);
  EXACT double slack = bound_above(s.extreme[LIST_LARGEST]) * s.span[k] * bits_double((1023u - 46u) << 20, 0u) +
                       (is_periodic(s, k) ? bits_double(0x3EB0C6F8u, 0u) : zero);  // 1e-6
  axis.slack = slack;
  return axis;
}

// Upper bounds: of a wrapped point's coordinates and its reach; of the numbers that are added to move a point to an
// image.
FN double list_size(ListSystem s, ListAxis x, ListAxis y, ListAxis z) {
  EXACT double largest = bits_double(0u, 0u);
  for (uint axis = 0u; axis < 3u; ++axis) {
    EXACT double along = x.extent * magnitude(s.row.of[axis]) + y.extent * magnitude(s.row.of[3u + axis]) +
                         z.extent * magnitude(s.row.of[6u + axis]);
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

// Sets where the cells along axis k begin, and how many there are in a unit of its coordinate.
FN ListSystem with_axis(ListSystem s, uint k, ListAxis axis) {
  EXACT double per_unit = double(s.cells[k]) / axis.extent;
  s.low[k] = axis.low;
  s.slack[k] = axis.slack;
  s.cells_per_unit[k] = axis.extent > bits_double(0u, 0u) ? per_unit : bits_double(0u, 0u);
  for (uint along = 0u; along < 3u; ++along) {
    EXACT double origin = s.origin[along] + axis.low * s.row.of[3u * k + along];
    s.origin[along] = origin;
  }
  return s;
}

// Sets the images along each axis that a wrapped point of 0 <= coordinate <= 1 may reach, and the bits of their number.
FN ListSystem with_images(ListSystem s) {
  EXACT double all = bits_double(0x3FF00000u, 0u);
  for (uint k = 0u; k < 3u; ++k) {
    EXACT double span = largest_reach(s) * s.span[k] + s.slack[k];
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
// d^2 - c^2 by less than e (2r + e). Squares are rounded four times, each time by 2^-24 (r + e)^2 at most, and
// reaches five times, each time by 2^-24 r at most, which moves their square by 2^-23 r^2: 14 times 2^-24 (r + e)^2 in
// all, of which 2^-20 (r + e)^2 covers 16.
FN ListSystem list_planned(ListSystem s, ListState state) {
  double zero = bits_double(0u, 0u);
  EXACT double reach = state.cutoff + state.skin + bound_above(s.extreme[LIST_RADIUS]);
  s.reach = reach;
  ListAxis x = list_axis(s, 0u);
  ListAxis y = list_axis(s, 1u);
  ListAxis z = list_axis(s, 2u);
  s = with_cells(s, (state.flags & LIST_ASKS) != 0u, x.reaches, y.reaches, z.reaches);
  for (uint k = 0u; k < 3u; ++k) s.origin[k] = zero;
  s = with_axis(s, 0u, x);
  s = with_axis(s, 1u, y);
  s = with_axis(s, 2u, z);
  s = with_images(s);
  double size = list_size(s, x, y, z);
  uint exponent = (double_high(size) >> 20) + 1u;  // of a power of two above the size
  s.scale = size > zero ? bits_double((2046u - exponent) << 20, 0u) : bits_double(0x3FF00000u, 0u);
  EXACT double rounded = list_added(s) * s.scale * bits_double((1023u - 46u) << 20, 0u);
  EXACT double error = rounded * bits_double(0x40200000u, 0u) + bits_double((1023u - 21u) << 20, 0u);
  EXACT double farthest = largest_reach(s) * s.scale + error;
  EXACT double tolerance = farthest * (error + error + farthest * bits_double((1023u - 20u) << 20, 0u));
  s.tolerance = float(tolerance);
  EXACT double part = (state.cutoff + state.skin) * s.scale;
  s.reach_part = float(part);
  return s;
}

// Whether the points of a system times the images within its reach are more than keys can number.
FN bool spans_too_much(ListSystem s) {
  if (s.key_bits > 31u) return true;
  EXACT double keys = double(s.end_point - s.first_point) * double(1u << s.key_bits);
  return keys > bits_double(0x41F00000u, 0u);  // 2^32
}

#endif
